// Separates all teeth of a scan: clicks as the library proposes them, or all in one step; labels and teeth to files.
// SPDX-License-Identifier: Apache-2.0
program segment_arch;

{$IFDEF FPC}{$MODE DELPHI}{$ENDIF}
{$IFNDEF FPC}{$APPTYPE CONSOLE}{$ENDIF}

uses
{$IFDEF FPC}
{$IFDEF UNIX}
  cthreads, BaseUnix,
{$ENDIF}
{$ENDIF}
{$IFDEF MSWINDOWS}
  Windows,
{$ENDIF}
  SysUtils, Classes, toothseg, toothseg_api;

const
  Usage =
    'usage: segment_arch SCAN [options]' + sLineBreak + sLineBreak +
    '  --all            all teeth in one step, not a click for each two' + sLineBreak +
    '  --labels OUT     a number a face, in the order of the faces in SCAN; 0: no tooth' + sLineBreak +
    '  --teeth DIR      the mesh of each tooth, tooth_LABEL.stl, closed' + sLineBreak +
    '  --threads N      worker threads; 0: one a core (the default)';
  ExitClickFailed = 1;
  ExitNothingWritten = 2;
  ExitInterrupted = 130;

type
  EUsage = class(Exception);

  TRun = class
  private
    FScan, FLabels, FTeeth: string;
    FAll, FSaving: Boolean;
    FThreads: Cardinal;
    FShown: Integer;
    FFailed: Integer;
    FContext: TTsContext;
    FJob: TTsJob;
    FModel: TTsModel;
    FFeatures: TTsFeatures;
    FSegmentation: TTsSegmentation;
    procedure Log(Level: TTsLogLevel; const Text: string);
    function Progress(Fraction: Double; const Stage: string): Boolean;
    procedure ClickForUser;
    procedure SaveLabels;
    procedure SaveTeeth;
  public
    constructor Create;
    destructor Destroy; override;
    procedure Go;
    property Failed: Integer read FFailed;
  end;

var
  Interrupted: Boolean; // by Ctrl-C; looked at whenever the library tells how far it is

{$IFDEF MSWINDOWS}
function Interrupt(Event: DWORD): BOOL; stdcall;
begin
  Result := Event = CTRL_C_EVENT;
  if Result then
    Interrupted := True;
end;
{$ELSE}
procedure Interrupt(Signal: cint); cdecl;
begin
  Interrupted := True;
end;
{$ENDIF}

procedure Tell(const Text: string);
begin
  WriteLn(ErrOutput, 'segment_arch: ', Text);
  Flush(ErrOutput);
end;

constructor TRun.Create;
var
  I: Integer;

  function Value: string;
  begin
    Inc(I);
    Result := ParamStr(I);
    if Result = '' then
      raise EUsage.Create(ParamStr(I - 1) + ': a value is missing');
  end;

begin
  I := 1;
  while I <= ParamCount do
  begin
    if ParamStr(I) = '--all' then
      FAll := True
    else if ParamStr(I) = '--labels' then
      FLabels := Value
    else if ParamStr(I) = '--teeth' then
      FTeeth := Value
    else if ParamStr(I) = '--threads' then
      FThreads := StrToInt(Value)
    else if (Copy(ParamStr(I), 1, 1) = '-') or (FScan <> '') then
      raise EUsage.Create(ParamStr(I) + ': unknown')
    else
      FScan := ParamStr(I);
    Inc(I);
  end;
  if FScan = '' then
    raise EUsage.Create('no scan given');
end;

destructor TRun.Destroy;
begin
  FSegmentation.Free;
  FFeatures.Free;
  FModel.Free;
  FJob.Free;
  FContext.Free;
  inherited;
end;

procedure TRun.Log(Level: TTsLogLevel; const Text: string);
begin
  if Level = TS_LOG_WARNING then
    Tell(FScan + ': ' + Text);
end;

// A line for each tenth of a call; the teeth's own calls are short.
function TRun.Progress(Fraction: Double; const Stage: string): Boolean;
var
  Tenth: Integer;
begin
  Tenth := Trunc(10 * Fraction);
  if (Tenth <> FShown) and not FSaving then
    Tell(Format('%3d %% %s', [10 * Tenth, Stage]));
  FShown := Tenth;
  Result := not Interrupted;
end;

// Clicks until nothing is left, or until a round separates nothing more.
procedure TRun.ClickForUser;
var
  Places: TTsPoints;
  Status: TTsStatus;
  Before: Integer;
begin
  repeat
    Before := Length(FSegmentation.Teeth);
    Places := FSegmentation.ProposeClicks;
    for Status in FSegmentation.Clicks(Places, FJob) do
      if Status <> TS_OK then
      begin
        Inc(FFailed);
        Tell(Format('%s: a click: %s', [FScan, TsStatusName(Status)]));
      end;
  until (Length(Places) = 0) or (Length(FSegmentation.Teeth) = Before);
end;

procedure TRun.SaveLabels;
var
  Lines: TMemoryStream;
  Face: Cardinal;
  Line: AnsiString;
begin
  Lines := TMemoryStream.Create;
  try
    for Face in FSegmentation.Labels do
    begin
      Line := AnsiString(IntToStr(Face)) + #10;
      Lines.WriteBuffer(Line[1], Length(Line));
    end;
    Lines.SaveToFile(FLabels);
  finally
    Lines.Free;
  end;
end;

procedure TRun.SaveTeeth;
var
  Options: TTsToothMeshOptions;
  Mesh: TTsMesh;
  Name: string;
  Tooth: Cardinal;
begin
  if not ForceDirectories(FTeeth) then
    raise Exception.Create(FTeeth + ': cannot be made');
  Options := TsToothMeshOptions;
  Options.Closed := 1;
  FSaving := True;
  for Tooth in FSegmentation.Teeth do
  begin
    Mesh := TTsMesh.OfTooth(FSegmentation, Tooth, Options, FJob);
    try
      Name := Format('%s%stooth_%d.stl', [FTeeth, PathDelim, Mesh.Info.Label_]);
      Tell(Name);
      Mesh.Save(Name, TS_OUTPUT_STL, FJob);
    finally
      Mesh.Free;
    end;
  end;
end;

procedure TRun.Go;
begin
  FContext := TTsContext.Create(FThreads, Log);
  FJob := TTsJob.Create(FContext, Progress);
  FModel := TTsModel.Load(FContext, FScan, FJob);
  FFeatures := TTsFeatures.Detect(FModel, FJob);
  FSegmentation := TTsSegmentation.Create(FFeatures, FJob);
  if FAll then
    FSegmentation.SegmentAll(FJob)
  else
    ClickForUser;
  if FLabels <> '' then
    SaveLabels;
  if FTeeth <> '' then
    SaveTeeth;
  WriteLn(Format('%s: %d teeth from %d clicks, %d failed', [FScan, Length(FSegmentation.Teeth), FSegmentation.ClickCount,
    FFailed]));
end;

procedure Main;
var
  Run: TRun;
begin
  Run := nil;
  try
    try
      Run := TRun.Create;
      Run.Go;
      if Run.Failed > 0 then
        ExitCode := ExitClickFailed;
    except
      on E: EUsage do
      begin
        Tell(E.Message);
        WriteLn(ErrOutput, Usage);
        ExitCode := ExitNothingWritten;
      end;
      on E: ETsCancelled do
      begin
        Tell('cancelled');
        ExitCode := ExitInterrupted;
      end;
      on E: ETsError do
      begin
        Tell(Format('%s: %s', [E.StatusName, E.Message]));
        ExitCode := ExitNothingWritten;
      end;
      on E: Exception do
      begin
        Tell(E.Message);
        ExitCode := ExitNothingWritten;
      end;
    end;
  finally
    Run.Free;
  end;
end;

begin
  {$IFDEF MSWINDOWS}
  SetConsoleCtrlHandler(@Interrupt, True);
  {$ELSE}
  FpSignal(SIGINT, Interrupt);
  {$ENDIF}
  Main;
end.
