// What the tests count with. SPDX-License-Identifier: Apache-2.0
unit checks;

{$MODE DELPHI}

interface

uses
  SysUtils, toothseg;

type
  TErrorClass = class of Exception;

procedure Section(const Name: string);
procedure Check(Ok: Boolean; const What: string);
procedure Expect(const What: string; Actual, Expected: Int64);
// In an exception handler: the exception is the one that has to be.
procedure Raised(E: Exception; Wanted: TErrorClass; Status: TTsStatus; const What: string);
// After a call that had to raise one.
procedure Missed(const What: string);
// The last line; the exit code.
procedure Conclude;

implementation

var
  Passed, Failed: Integer;
  Name: string;

procedure Section(const Name: string);
begin
  checks.Name := Name;
end;

procedure Check(Ok: Boolean; const What: string);
begin
  if Ok then
    Inc(Passed)
  else
  begin
    Inc(Failed);
    WriteLn('FAILED ', Name, ': ', What);
  end;
end;

procedure Expect(const What: string; Actual, Expected: Int64);
begin
  Check(Actual = Expected, Format('%s: %d, not %d', [What, Actual, Expected]));
end;

procedure Raised(E: Exception; Wanted: TErrorClass; Status: TTsStatus; const What: string);
begin
  Check(E.ClassType = Wanted, Format('%s: %s, not %s: %s', [What, E.ClassName, Wanted.ClassName, E.Message]));
  if E is ETsError then
  begin
    Expect(What + ': ' + E.Message, ETsError(E).Status, Status);
    Check((E.Message <> '') and (Pos(#10, E.Message) = 0), What + ': the message is one line');
  end;
end;

procedure Missed(const What: string);
begin
  Check(False, What + ': raised nothing');
end;

procedure Conclude;
begin
  WriteLn(Format('%d passed, %d failed', [Passed, Failed]));
  if Failed > 0 then
    ExitCode := 1;
end;

end.
