// Help, in a minute. SPDX-License-Identifier: Apache-2.0

const KEYS: [string, string][] = [
  ['← →, Tab', 'walk along the teeth (when the scan has the focus)'],
  ['Enter', 'click the tooth that is marked'],
  ['A', 'all teeth'],
  ['Ctrl+Z, Ctrl+Y', 'undo, redo'],
  ['1 to 5', 'tools'],
  ['F, G', 'field, feature points'],
  ['Shift+← →, ↑ ↓', 'turn the scan'],
  ['+ − 0', 'nearer, further, as at first'],
  ['Delete', 'remove the selected tooth, or point'],
  ['Ctrl+O, Ctrl+S', 'open, save the session'],
  ['T, ?', 'light or dark, this help'],
];

export function buildHelp(dialog: HTMLDialogElement): { show(): void } {
  dialog.innerHTML = `
    <h2>Separate teeth, one click a pair</h2>
    <ol>
      <li><b>Open</b> a scan of one jaw (STL, PLY, OBJ, OFF, in mm), or drop it anywhere. It stays in this browser.</li>
      <li><b>Point</b> at a tooth: it and the neighbour that a click would take are tinted.</li>
      <li><b>Click.</b> Both are separated. A whole arch takes about half as many clicks as it has teeth, or one on “All teeth”.</li>
      <li><b>Look</b> at the list: under 90 %, or with ⚠, a tooth wants a look. Is its number wrong? Choose the right one.</li>
      <li><b>Correct:</b> select a tooth in the list, then Shift-click. Beside it that means “this too”, on it “not this”.
          With “Move line” drag a white point of its line.</li>
      <li><b>Save</b> teeth, labelled scan, or the session, which opens again after its scan.</li>
    </ol>
    <p>Drag turns the scan, the right button moves it, the wheel zooms.</p>
    <table><tbody>${KEYS.map(([key, text]) => `<tr><th scope="row">${key}</th><td>${text}</td></tr>`).join('')}</tbody></table>
    <form method="dialog"><button class="main" autofocus>Got it</button></form>`;
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return { show: () => dialog.showModal() };
}
