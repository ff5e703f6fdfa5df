// The layouts of a later release, by the units made for it. SPDX-License-Identifier: Apache-2.0
program test_grown;

{$MODE DELPHI}

uses
  SysUtils, toothseg_api;

procedure Expect(const What: string; Actual, Expected: Int64);
begin
  if Actual = Expected then
    Exit;
  WriteLn(What, ': ', Actual, ', not ', Expected);
  ExitCode := 1;
end;

begin
  {$I layout.inc}
  Expect('TS_MOST_', TS_MOST_, 7);
end.
