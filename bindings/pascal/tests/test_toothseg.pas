// All tests: test_toothseg SCAN LABELS SMALL_SCAN FOLDER. LABELS: what ts-segment wrote for SCAN.
// SPDX-License-Identifier: Apache-2.0
program test_toothseg;

{$MODE DELPHI}

uses
  {$IFDEF UNIX}cthreads,{$ENDIF} SysUtils, checks, toothseg, toothseg_api, test_errors, test_objects, test_callbacks, test_results;

procedure TestLayout;
begin
  Section('layout');
  {$I layout.inc}
end;

begin
  TestLayout;
  TestCallbacks(ParamStr(1), ParamStr(3));
  TestErrors(ParamStr(1), ParamStr(3), ParamStr(4));
  TestObjects(ParamStr(3));
  TestResults(ParamStr(1), ParamStr(2), ParamStr(4));
  Conclude;
end.
