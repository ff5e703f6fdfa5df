#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the lowest layer from abi/toothseg.json: `generate.py` writes it, `generate.py --check` fails where it is not up to date.

Toothseg/Generated.cs  enums, structs, option classes, handles, callbacks and the P/Invoke declarations
tests/Layout.cs        what the C compiler says of every struct, for a test to compare with
"""
import json
import os
import sys
import textwrap
from xml.sax.saxutils import escape

HERE = os.path.dirname(os.path.abspath(__file__))
ABI = os.path.join(HERE, '..', '..', 'abi', 'toothseg.json')

SCALARS = {'double': 'double', 'float': 'float', 'int': 'int', 'int32_t': 'int', 'uint32_t': 'uint', 'int64_t': 'long',
           'uint64_t': 'ulong', 'uint8_t': 'byte', 'int8_t': 'sbyte', 'uint16_t': 'ushort', 'int16_t': 'short',
           'size_t': 'UIntPtr', 'char': 'byte', 'void': 'void'}

# What C's types do not tell: integers that are yes or no, and integers that are sums of an enum's values.
YES_NO = {'ts_cut_info.closed', 'ts_feature_point.by_hand', 'ts_features_info.inside_out', 'ts_number_info.set_by_hand',
          'ts_number_info.uncertain', 'ts_jaw_info.given', 'ts_jaw_info.uncertain', 'ts_review_item.separated',
          'ts_number_options.mirrored', 'ts_tooth_mesh_options.closed', 'ts_save_options.whole_faces',
          'ts_segment_options.reject_outliers', 'ts_history_info.complete', 'ts_tooth_frame.from_arch'}
SUMS = {'ts_features_info.warnings': 'ts_features_warning', 'ts_tooth_info.warnings': 'ts_tooth_warning',
        'ts_review_item.warnings': 'ts_tooth_warning'}

KEYWORDS = {'event', 'object', 'params', 'ref', 'out', 'in', 'lock', 'base', 'string', 'fixed', 'checked', 'is', 'as'}


def pascal(name):
    return ''.join(part[:1].upper() + part[1:] for part in name.split('_') if part)


def public_name(c_name):
    return pascal(c_name[len('ts_'):])


def is_sum(enum):
    return enum.endswith('_warning') or enum.endswith('_flag')


def enum_name(c_name):
    return public_name(c_name) + ('s' if is_sum(c_name) else '')


def handle_name(c_name):
    return public_name(c_name) + 'Handle'


def parameter(name):
    return '@' + name if name in KEYWORDS else name


class Writer:
    def __init__(self, what):
        self.lines = ['// SPDX-License-Identifier: Apache-2.0', '// %s Made by generate.py from abi/toothseg.json.' % what]

    def put(self, text='', depth=0):
        self.lines.append(('    ' * depth + text) if text else '')

    def doc(self, text, depth):
        if text:
            wrapped = textwrap.wrap('<summary>' + escape(text) + '</summary>', 116 - 4 * depth, break_long_words=False,
                                    break_on_hyphens=False)
            for line in wrapped:
                self.put('/// ' + line, depth)

    def text(self):
        return '\n'.join(self.lines) + '\n'


class Api:
    def __init__(self, data):
        self.data = data
        self.structs = {s['name']: s for s in data['structs']}
        self.destroys = {h['destroy']: h['name'] for h in data['handles']}
        fields = {'%s.%s' % (s['name'], f['name']) for s in data['structs'] for f in s['fields']}
        gone = (YES_NO | set(SUMS)) - fields
        if gone:
            sys.exit('generate.py: no such fields: ' + ', '.join(sorted(gone)))

    def is_raw(self, struct):
        """Holds pointers of the caller's: for the public layer to fill."""
        return any(f['type'].get('pointer') or f['type']['kind'] == 'callback' for f in struct['fields'])

    def is_options(self, struct):
        return bool(struct.get('init')) and not self.is_raw(struct)

    def is_internal(self, struct):
        return self.is_raw(struct) or self.is_options(struct)

    def struct_name(self, c_name):
        return c_name if self.is_internal(self.structs[c_name]) else public_name(c_name)

    def value_type(self, t):
        """The type without its stars."""
        if t['kind'] == 'enum':
            return enum_name(t['base'])
        if t['kind'] == 'struct':
            return self.struct_name(t['base'])
        if t['kind'] in ('handle', 'callback'):
            return 'IntPtr'
        if t['base'] not in SCALARS:
            sys.exit('generate.py: do not know the type ' + t['spelling'])
        return SCALARS[t['base']]

    def argument_type(self, t, destroys=False):
        stars = t.get('pointer', 0)
        if t['kind'] == 'handle':
            if stars == 1:
                return 'IntPtr' if destroys else handle_name(t['base'])
            return 'IntPtr' + '*' * (stars - 1)
        if t.get('length'):
            return ('Point' if is_point(t) else self.value_type(t)) + '*'
        return self.value_type(t) + '*' * stars


def is_point(t):
    return t['base'] == 'double' and t.get('length') == 3 and not t.get('pointer')


# ------------------------------------------------------------------------------------------------------------ pieces

def enums(api, w):
    for e in api.data['enums']:
        forced = [v['name'] for v in e['values'] if v['name'].endswith('FORCE_INT')]
        prefix = forced[0][:-len('FORCE_INT')] if forced else 'TS_'
        w.doc(e['doc'], 1)
        if is_sum(e['name']):
            w.put('[Flags]', 1)
        w.put('public enum %s : %s' % (enum_name(e['name']), 'uint' if is_sum(e['name']) else 'int'), 1)
        w.put('{', 1)
        if is_sum(e['name']) and all(v['value'] for v in e['values']):
            w.put('None = 0,', 2)
        for v in e['values']:
            if v['name'] in forced:
                continue
            name = v['name']
            for start in (prefix, 'TS_E_', 'TS_'):
                if name.startswith(start):
                    name = name[len(start):]
                    break
            w.doc(v['doc'], 2)
            w.put('%s = %d,' % (pascal(name.lower()), v['value']), 2)
        w.put('}', 1)
        w.put()


def storage_name(struct, field, public):
    """The C# field; those that have a property in front of them are not public."""
    return field['name'] if not public or has_property(struct, field) else pascal(field['name'])


def has_property(struct, field):
    return '%s.%s' % (struct['name'], field['name']) in YES_NO or text_length(field) > 0


def text_length(field):
    t = field['type']
    return t.get('length', 0) if t['base'] == 'char' and not t.get('pointer') else 0


def field_type(api, struct, field):
    key = '%s.%s' % (struct['name'], field['name'])
    t = field['type']
    if key in SUMS:
        return enum_name(SUMS[key])
    if is_point(t):
        return 'Point'
    return api.value_type(t) + '*' * (t.get('pointer', 0) if t['kind'] not in ('handle', 'callback') else 0)


def structs(api, w):
    for s in api.data['structs']:
        if api.is_internal(s):
            continue
        w.doc(s['doc'], 1)
        w.put('[StructLayout(LayoutKind.Sequential)]', 1)
        w.put('public unsafe struct %s' % public_name(s['name']), 1)
        w.put('{', 1)
        for f in s['fields']:
            struct_field(api, w, s, f, 2, True)
        w.put('}', 1)
        w.put()


def struct_field(api, w, s, f, depth, public):
    name = storage_name(s, f, public)
    hidden = not public or has_property(s, f) or f['name'] in ('struct_size', 'reserved')
    access = 'internal' if hidden else 'public'
    if not hidden:
        w.doc(f.get('doc', ''), depth)
    kind = field_type(api, s, f)
    if f['type'].get('length') and kind != 'Point':
        w.put('%s fixed %s %s[%d];' % (access, kind, parameter(name), f['type']['length']), depth)
    else:
        w.put('%s %s %s;' % (access, kind, parameter(name), ), depth)
    if public and has_property(s, f):
        w.doc(f.get('doc', ''), depth)
        if text_length(f):
            w.put('public string %s { get { fixed (byte* text = %s) return Text.Decode(text, %d); } }' %
                  (pascal(f['name']), parameter(name), text_length(f)), depth)
        else:
            w.put('public bool %s { get { return %s != 0; } }' % (pascal(f['name']), parameter(name)), depth)


def option_classes(api, w):
    for s in api.data['structs']:
        if api.is_options(s):
            option_class(api, w, s)


def option_class(api, w, s):
    init = next(f for f in api.data['functions'] if f['name'] == s['init'])
    more = init['arguments'][2:]
    name = public_name(s['name'])
    w.doc(s['doc'] or 'Options, initialised to the defaults of the library.', 1)
    w.put('public sealed unsafe class %s' % name, 1)
    w.put('{', 1)
    w.put('internal %s Value;' % s['name'], 2)
    w.put()
    declared = ', '.join('%s %s' % (api.argument_type(a['type']), parameter(a['name'])) for a in more)
    passed = ''.join(', ' + parameter(a['name']) for a in more)
    if more:
        default = ', '.join('default(%s)' % api.argument_type(a['type']) for a in more)
        w.put('public %s() : this(%s) { }' % (name, default), 2)
    w.put('public %s(%s)' % (name, declared), 2)
    w.put('{', 2)
    w.put('%s value;' % s['name'], 3)
    w.put('ToothsegException.Check(Native.%s(&value, (uint)sizeof(%s)%s));' % (s['init'], s['name'], passed), 3)
    w.put('Value = value;', 3)
    w.put('}', 2)
    for f in s['fields']:
        if f['name'] in ('struct_size', 'reserved'):
            continue
        w.doc(f.get('doc', ''), 2)
        field = 'Value.' + parameter(f['name'])
        if has_property(s, f):
            w.put('public bool %s { get { return %s != 0; } set { %s = value ? 1u : 0u; } }' %
                  (pascal(f['name']), field, field), 2)
        else:
            w.put('public %s %s { get { return %s; } set { %s = value; } }' %
                  (field_type(api, s, f), pascal(f['name']), field, field), 2)
    w.put('}', 1)
    w.put()


def internal_structs(api, w):
    for s in api.data['structs']:
        if not api.is_internal(s):
            continue
        w.put('[StructLayout(LayoutKind.Sequential)]', 1)
        w.put('internal unsafe struct %s' % s['name'], 1)
        w.put('{', 1)
        for f in s['fields']:
            struct_field(api, w, s, f, 2, False)
        w.put('}', 1)
        w.put()


def handles(api, w):
    for h in api.data['handles']:
        name = handle_name(h['name'])
        w.put('internal sealed class %s : Handle' % name, 1)
        w.put('{', 1)
        w.put('internal %s(Hooks? hooks) : base(hooks) { }' % name, 2)
        w.put('protected override void Destroy(IntPtr native) { Native.%s(native); }' % h['destroy'], 2)
        w.put('}', 1)
        w.put()


def callbacks(api, w):
    for c in api.data['callbacks']:
        arguments = ', '.join('%s %s' % (api.argument_type(a['type']), parameter(a['name'])) for a in c['arguments'])
        w.put('[UnmanagedFunctionPointer(CallingConvention.Cdecl)]', 1)
        w.put('internal unsafe delegate %s %s(%s);' % (api.argument_type(c['returns']), c['name'], arguments), 1)
        w.put()


def functions(api, w):
    w.put('internal static unsafe class Native', 1)
    w.put('{', 1)
    w.put('private const string Library = "toothseg";', 2)
    w.put()
    for c in api.data['constants']:
        w.put('internal const uint %s = %du;' % (c['name'], c['value']), 2)
    for f in api.data['functions']:
        destroys = f['name'] in api.destroys
        arguments = ', '.join('%s %s' % (api.argument_type(a['type'], destroys), parameter(a['name'])) for a in f['arguments'])
        w.put()
        w.put('[DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]', 2)
        w.put('internal static extern %s %s(%s);' % (api.argument_type(f['returns']), f['name'], arguments), 2)
    w.put('}', 1)


def generated(api):
    w = Writer('The C API in C#.')
    w.put('#nullable enable')
    w.put('using System;')
    w.put('using System.Runtime.InteropServices;')
    w.put()
    w.put('namespace Toothseg')
    w.put('{')
    for piece in (enums, structs, option_classes, internal_structs, handles, callbacks, functions):
        piece(api, w)
    w.put('}')
    return w.text()


def layout(api):
    w = Writer('Sizes and offsets of C.')
    w.put('static class Layout')
    w.put('{')
    w.put('// C# name, size, then field and offset in turn.', 1)
    w.put('internal static readonly object[][] Structs =', 1)
    w.put('{', 1)
    for s in api.data['structs']:
        there = s['layout']['lp64']
        fields = ', '.join('"%s", %d' % (storage_name(s, f, not api.is_internal(s)), there['offsets'][f['name']])
                           for f in s['fields'])
        w.put('new object[] { "%s", %d, %s },' % (api.struct_name(s['name']), there['size'], fields), 2)
    w.put('};', 1)
    w.put()
    w.put('internal static readonly string[] Functions =', 1)
    w.put('{', 1)
    for f in api.data['functions']:
        w.put('"%s",' % f['name'], 2)
    w.put('};', 1)
    w.put('}')
    return w.text()


def main():
    abi = ABI
    arguments = sys.argv[1:]
    check = '--check' in arguments
    if any(a != '--check' for a in arguments):
        sys.exit('usage: generate.py [--check]')
    with open(abi, encoding='utf-8') as file:
        api = Api(json.load(file))
    for path, text in (('Toothseg/Generated.cs', generated(api)), ('tests/Layout.cs', layout(api))):
        full = os.path.join(HERE, path)
        if check:
            there = open(full, encoding='utf-8').read() if os.path.exists(full) else ''
            if there != text:
                sys.exit('%s is not what abi/toothseg.json says: run bindings/csharp/generate.py' % path)
        else:
            with open(full, 'w', encoding='utf-8') as file:
                file.write(text)


if __name__ == '__main__':
    main()
