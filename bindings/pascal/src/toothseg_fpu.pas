// Floating-point exceptions around calls of C++ code. SPDX-License-Identifier: Apache-2.0
//
// Pascal lets a division by zero or an invalid operation raise an exception; C++ code is made for a processor that goes on
// with an infinity or a NaN, and would be struck by a signal in the midst of its work. So the exceptions are masked while
// the library runs, also on the threads that it makes, which inherit that, and are as they were in all Pascal code,
// callbacks included.
unit toothseg_fpu;

{$IFDEF FPC}
{$MODE DELPHI}
{$S-} // a stack check uses a threadvar, which on a thread of C++ sets the very thing that is read here
{$IFDEF CPUX86_64}
{$DEFINE TS_CONTROL_WORDS}
{$ASMMODE INTEL}
{$ENDIF}
{$ENDIF}

interface

uses
  Math;

type
  // The calling thread's control of floating-point exceptions.
  TTsFpu = record
{$IFDEF TS_CONTROL_WORDS}
    X87: Word;
    Sse: Cardinal;
{$ELSE}
    Mask: {$IF DECLARED(TArithmeticExceptionMask)}TArithmeticExceptionMask{$ELSE}TFPUExceptionMask{$IFEND};
{$ENDIF}
  end;

procedure TsReadFpu(out Fpu: TTsFpu);
procedure TsLoadFpu(const Fpu: TTsFpu);
// Masks all exceptions; Fpu: what was before.
procedure TsMaskFpu(out Fpu: TTsFpu);

implementation

{$IFDEF TS_CONTROL_WORDS}

// The words themselves, not SetExceptionMask: that of Free Pascal also sets what threads of the program made later begin
// with, and is slow.
procedure TsReadFpu(out Fpu: TTsFpu);
var
  X87: Word;
  Sse: Cardinal;
begin
  asm
    fnstcw X87
    stmxcsr Sse
  end;
  Fpu.X87 := X87;
  Fpu.Sse := Sse;
end;

procedure TsLoadFpu(const Fpu: TTsFpu);
var
  X87: Word;
  Sse: Cardinal;
begin
  X87 := Fpu.X87;
  Sse := Fpu.Sse;
  asm
    // What happened while exceptions were masked must not be raised when they no longer are.
    fnstsw ax
    test al, 3Fh
    jz @clean
    fnclex
  @clean:
    fldcw X87
    ldmxcsr Sse
  end ['rax'];
end;

procedure TsMaskFpu(out Fpu: TTsFpu);
const
  X87All = $3F;
  SseAll = $1F80;
var
  Masked: TTsFpu;
begin
  TsReadFpu(Fpu);
  if (Fpu.X87 and X87All = X87All) and (Fpu.Sse and SseAll = SseAll) then
    Exit;
  Masked.X87 := Fpu.X87 or X87All;
  Masked.Sse := Fpu.Sse or SseAll;
  TsLoadFpu(Masked);
end;

{$ELSE}

procedure TsReadFpu(out Fpu: TTsFpu);
begin
  Fpu.Mask := GetExceptionMask;
end;

procedure TsLoadFpu(const Fpu: TTsFpu);
begin
  ClearExceptions(False);
  SetExceptionMask(Fpu.Mask);
end;

procedure TsMaskFpu(out Fpu: TTsFpu);
begin
  Fpu.Mask := SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);
end;

{$ENDIF}

end.
