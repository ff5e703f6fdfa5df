// Progress, cancelling, log, changes, threads, and floating-point exceptions around all of them.
// SPDX-License-Identifier: Apache-2.0
unit test_callbacks;

{$MODE DELPHI}

interface

procedure TestCallbacks(const Scan, SmallScan: string);

implementation

uses
  SysUtils, Classes, Math, checks, fixture, toothseg, toothseg_api, toothseg_fpu;

type
  EOwn = class(Exception);

  TCanceller = class(TThread)
  public
    Job: TTsJob;
    Go, Done: PRTLEvent;
    procedure Execute; override;
  end;

  TTrapper = class(TThread)
  public
    Traps: Boolean;
    procedure Execute; override;
  end;

  TReader = class(TThread)
  public
    F: TFixture;
    Labels: TTsIndices;
    Positions: TTsPoints;
    Sum: Double;
    Trouble: string;
    procedure Execute; override;
  end;

  TWorker = class(TThread)
  public
    Scan: string;
    Labels: TTsIndices;
    Trouble: string;
    function Progress(Fraction: Double; const Stage: string): Boolean;
    procedure Execute; override;
  end;

  // What the library is told to call.
  TListener = class
  public
    Calls, Rising, Foreign, Trapped, Lines: Integer;
    Last: Double;
    Main: TThreadID;
    Changed, InChange: TTsIndices;
    Segmentation: TTsSegmentation;
    Canceller: TCanceller;
    function Count(Fraction: Double; const Stage: string): Boolean;
    function Refuse(Fraction: Double; const Stage: string): Boolean;
    function Fail(Fraction: Double; const Stage: string): Boolean;
    function WaitForCancel(Fraction: Double; const Stage: string): Boolean;
    procedure Log(Level: TTsLogLevel; const Text: string);
    procedure FailLog(Level: TTsLogLevel; const Text: string);
    procedure Change(const Teeth: TTsIndices);
    procedure FailChange(const Teeth: TTsIndices);
  end;

var
  Zero: Double = 0;

// Whether floating-point exceptions are raised here, as Pascal has it.
function Traps: Boolean;
begin
  try
    Result := 1 / Zero < 0; // infinity, where they are masked
  except
    on EZeroDivide do
      Result := True;
  end;
end;

procedure TTrapper.Execute;
begin
  Traps := test_callbacks.Traps;
end;

procedure TCanceller.Execute;
begin
  RTLEventWaitFor(Go);
  Job.Cancel;
  RTLEventSetEvent(Done);
end;

procedure TReader.Execute;
var
  I: Integer;
begin
  try
    for I := 1 to 10 do
    begin
      Labels := F.Segmentation.Labels;
      Positions := F.Model.Positions;
    end;
    for I := 0 to 999 do
      Sum := Sum + F.Model.Nearest(Positions[I]).Distance;
    {$IFDEF UNIX} // on Windows a thread begins as the system has it: masked
    if not Traps then
      Trouble := 'floating-point exceptions stayed masked';
    {$ENDIF}
  except
    on E: Exception do
      Trouble := E.Message;
  end;
end;

function TWorker.Progress(Fraction: Double; const Stage: string): Boolean;
begin
  Result := Stage <> '';
end;

procedure TWorker.Execute;
var
  Keep: ITsKeeper;
  Context: TTsContext;
  Job: TTsJob;
  Model: TTsModel;
  Features: TTsFeatures;
  Segmentation: TTsSegmentation;
begin
  try
    Keep := TsKeeper;
    Context := TTsContext.Create;
    Keep.Add(Context);
    Job := TTsJob.Create(Context, Progress);
    Keep.Add(Job);
    Model := TTsModel.Load(Context, Scan, Job);
    Keep.Add(Model);
    Features := TTsFeatures.Detect(Model, Job);
    Keep.Add(Features);
    Segmentation := TTsSegmentation.Create(Features, Job);
    Keep.Add(Segmentation);
    Segmentation.SegmentAll(Job);
    Labels := Segmentation.Labels;
  except
    on E: Exception do
      Trouble := E.Message;
  end;
end;

function TListener.Count(Fraction: Double; const Stage: string): Boolean;
begin
  Inc(Calls);
  if (Fraction >= Last) and (Stage <> '') then
    Inc(Rising);
  Last := Fraction;
  if GetCurrentThreadId <> Main then
    Inc(Foreign);
  if Traps then
    Inc(Trapped);
  Result := True;
end;

function TListener.Refuse(Fraction: Double; const Stage: string): Boolean;
begin
  Result := False;
end;

function TListener.Fail(Fraction: Double; const Stage: string): Boolean;
begin
  raise EOwn.Create('of the progress');
end;

function TListener.WaitForCancel(Fraction: Double; const Stage: string): Boolean;
const
  Patience = 10000;
begin
  RTLEventSetEvent(Canceller.Go);
  RTLEventWaitFor(Canceller.Done, Patience);
  RTLEventSetEvent(Canceller.Done); // for the calls that follow
  Result := True;
end;

procedure TListener.Log(Level: TTsLogLevel; const Text: string);
begin
  if (Text <> '') and Traps then
    InterlockedIncrement(Lines);
end;

procedure TListener.FailLog(Level: TTsLogLevel; const Text: string);
begin
  raise EOwn.Create('of the log');
end;

procedure TListener.Change(const Teeth: TTsIndices);
begin
  Inc(Calls);
  if Traps then
    Inc(Trapped);
  Changed := Teeth;
  InChange := Segmentation.Teeth; // reading is allowed
end;

procedure TListener.FailChange(const Teeth: TTsIndices);
begin
  raise EOwn.Create('of the change');
end;

// A call back on a thread that Pascal has not made, which is chance where the library's are at work.
{$IFDEF UNIX}
function pthread_create(Thread, Attributes, Start, Parameter: Pointer): Integer; cdecl; external 'c';
function pthread_join(Thread: PtrUInt; Value: Pointer): Integer; cdecl; external 'c';

function OnForeignThread(Start, Parameter: Pointer): Boolean;
var
  Thread: PtrUInt;
begin
  Result := (pthread_create(@Thread, nil, Start, Parameter) = 0) and (pthread_join(Thread, nil) = 0);
end;
{$ELSE}
function CreateThread(Attributes: Pointer; Stack: PtrUInt; Start, Parameter: Pointer; Flags: Cardinal; Id: Pointer): THandle;
  stdcall; external 'kernel32';
function WaitForSingleObject(Handle: THandle; Milliseconds: Cardinal): Cardinal; stdcall; external 'kernel32';
function CloseHandle(Handle: THandle): LongBool; stdcall; external 'kernel32';

function OnForeignThread(Start, Parameter: Pointer): Boolean;
var
  Thread: THandle;
begin
  Thread := CreateThread(nil, 0, Start, Parameter, 0, nil);
  Result := (Thread <> 0) and (WaitForSingleObject(Thread, $FFFFFFFF) = 0) and CloseHandle(Thread);
end;
{$ENDIF}

type
  TForeign = record
    Model: Pts_model;
    Job: Pts_job;
    Features: Pts_features;
    Status: ts_status;
    Before, After: TTsFpu;
  end;

{$PUSH}
{$S-} // a stack check uses a threadvar
function RunForeign(Parameter: Pointer): Pointer; cdecl;
var
  Fpu: TTsFpu;
  Foreign: ^TForeign;
begin
  Foreign := Parameter;
  TsMaskFpu(Fpu);
  TsReadFpu(Foreign.Before);
  Foreign.Status := ts_detect_features(Foreign.Model, nil, Foreign.Job, @Foreign.Features);
  TsReadFpu(Foreign.After);
  ts_features_destroy(Foreign.Features);
  Result := nil;
end;
{$POP}

procedure TestForeignThread(Model: TTsModel);
const
  Control = not Cardinal($3F); // without what has happened
var
  L: TListener;
  Context: TTsContext;
  Job: TTsJob;
  Foreign: TForeign;
begin
  L := TListener.Create;
  L.Main := GetCurrentThreadId;
  Context := TTsContext.Create(1);
  Job := TTsJob.Create(Context, L.Count);
  FillChar(Foreign, SizeOf(Foreign), 0);
  Foreign.Model := Model.Handle;
  Foreign.Job := Job.Handle;
  Check(OnForeignThread(@RunForeign, @Foreign), 'a thread');
  Expect('its call', Foreign.Status, TS_OK);
  Check(L.Foreign > 0, 'calls back on it');
  Expect('floating-point exceptions are raised there', L.Trapped, L.Calls);
  Check((Foreign.Before.X87 = Foreign.After.X87) and (Foreign.Before.Sse and Control = Foreign.After.Sse and Control),
    'and are masked again for the library');
  Job.Free;
  Context.Free;
  L.Free;
end;

procedure TestProgress(const Scan: string);
var
  L: TListener;
  Context: TTsContext;
  Model: TTsModel;
  Job, Refusing, Failing, Waiting: TTsJob;
  Features: TTsFeatures;
begin
  Section('progress');
  L := TListener.Create;
  L.Main := GetCurrentThreadId;
  Context := TTsContext.Create(4);
  Check(not IsMultiThread, 'without callbacks a program is as it was');
  Job := TTsJob.Create(Context, L.Count);
  Check(IsMultiThread, 'with callbacks its heap is ready for threads that are not its own');
  Refusing := TTsJob.Create(Context, L.Refuse);
  Failing := TTsJob.Create(Context, L.Fail);
  Waiting := TTsJob.Create(Context, L.WaitForCancel);
  Model := TTsModel.Load(Context, Scan);
  Features := TTsFeatures.Detect(Model, Job);
  Check(L.Calls > 3, 'called');
  Expect('never falling', L.Rising, L.Calls);
  Expect('1 at the end', Trunc(Job.Progress), 1);
  Expect('floating-point exceptions are raised in callbacks', L.Trapped, L.Calls);
  Check(Traps, 'and after the call');
  L.Last := 0;
  TTsSegmentation.Create(Features, Job).Free;
  Expect('floating-point exceptions are raised in all of them', L.Trapped, L.Calls);
  TestForeignThread(Model);

  try TTsSegmentation.Create(Features, Refusing); Missed('refused') except on E: Exception do Raised(E, ETsCancelled, TS_E_CANCELLED, 'refused') end;
  try TTsSegmentation.Create(Features, Failing); Missed('raised') except on E: Exception do Raised(E, EOwn, TS_OK, 'raised') end;
  Failing.Reset;
  try TTsSegmentation.Create(Features, Failing); Missed('raised again') except on E: Exception do Raised(E, EOwn, TS_OK, 'raised again') end;

  L.Canceller := TCanceller.Create(True);
  L.Canceller.Job := Waiting;
  L.Canceller.Go := RTLEventCreate;
  L.Canceller.Done := RTLEventCreate;
  L.Canceller.Start;
  try TTsSegmentation.Create(Features, Waiting); Missed('cancelled') except on E: Exception do Raised(E, ETsCancelled, TS_E_CANCELLED, 'cancelled by a thread') end;
  L.Canceller.WaitFor;
  RTLEventDestroy(L.Canceller.Go);
  RTLEventDestroy(L.Canceller.Done);
  L.Canceller.Free;
  Check(Traps, 'floating-point exceptions after errors');

  Features.Free;
  Model.Free;
  Waiting.Free;
  Failing.Free;
  Refusing.Free;
  Job.Free;
  Context.Free;
  L.Free;
end;

procedure TestChange(const SmallScan: string);
var
  F: TFixture;
  L: TListener;
  Teeth: Integer;
begin
  Section('change');
  F := TFixture.Create(SmallScan, False);
  L := TListener.Create;
  L.Segmentation := F.Segmentation;
  F.Segmentation.OnChange := L.Change;
  F.Segmentation.Click(F.Segmentation.ProposeClicks[0]);
  Expect('called', L.Calls, 1);
  Expect('floating-point exceptions are raised there', L.Trapped, 1);
  Check(SameIndices(L.Changed, F.Segmentation.Changes), 'tells what Changes tells');
  Check(SameIndices(L.InChange, F.Segmentation.Teeth), 'comes after the change');
  F.Segmentation.OnChange := L.FailChange;
  Teeth := Length(F.Segmentation.Teeth);
  try F.Segmentation.SegmentAll; Missed('raised') except on E: Exception do Raised(E, EOwn, TS_OK, 'raised') end;
  Check(Length(F.Segmentation.Teeth) > Teeth, 'the change itself stands');
  F.Segmentation.OnChange := nil;
  F.Segmentation.Undo;
  Expect('not called any more', L.Calls, 1);
  F.Free;
  L.Free;
end;

procedure TestLog(const SmallScan: string);
var
  L: TListener;
  Context: TTsContext;
  Model: TTsModel;
begin
  Section('log');
  L := TListener.Create;
  Context := TTsContext.Create(0, L.Log);
  Model := TTsModel.Load(Context, SmallScan);
  TTsFeatures.Detect(Model).Free;
  Check(L.Lines > 0, 'lines');
  Model.Free;
  Context.Free;
  Context := TTsContext.Create(0, L.FailLog);
  Model := nil;
  try
    Model := TTsModel.Load(Context, SmallScan);
    TTsFeatures.Detect(Model).Free;
    Missed('raised');
  except
    on E: Exception do
      Raised(E, EOwn, TS_OK, 'raised');
  end;
  Model.Free;
  Context.Free;
  L.Free;
end;

procedure TestThreads(const Scan, SmallScan: string);
var
  F: TFixture;
  Readers: array [0 .. 1] of TReader;
  Workers: array [0 .. 1] of TWorker;
  I: Integer;
begin
  Section('threads');
  F := TFixture.Create(Scan);
  for I := 0 to 1 do
  begin
    Readers[I] := TReader.Create(True);
    Readers[I].F := F;
    Readers[I].Start;
  end;
  for I := 0 to 1 do
  begin
    Readers[I].WaitFor;
    Check(Readers[I].Trouble = '', Readers[I].Trouble);
    Check(SameIndices(Readers[I].Labels, F.Segmentation.Labels), 'the labels of a reader');
    Check(Readers[I].Sum < 1e-6, 'vertices are on the surface');
    Readers[I].Free;
  end;
  F.Free;
  for I := 0 to 1 do
  begin
    Workers[I] := TWorker.Create(True);
    Workers[I].Scan := SmallScan;
    Workers[I].Start;
  end;
  for I := 0 to 1 do
  begin
    Workers[I].WaitFor;
    Check(Workers[I].Trouble = '', Workers[I].Trouble);
  end;
  Check((Workers[0].Labels <> nil) and SameIndices(Workers[0].Labels, Workers[1].Labels), 'two at work, the same labels');
  for I := 0 to 1 do
    Workers[I].Free;
end;

procedure TestControl(const SmallScan: string);
var
  Trapper: TTrapper;
  Extended87: Extended;
  F: TFixture;
begin
  Section('floating point');
  Check(Traps, 'exceptions are raised before any call');
  F := TFixture.Create(SmallScan);
  Check(Traps, 'and after them');
  // Were a flag of the x87 unit left standing, this would raise it.
  Extended87 := Zero;
  Extended87 := Extended87 + 1;
  Check(Extended87 = 1, 'no exception is pending');
  Trapper := TTrapper.Create(False);
  Trapper.WaitFor;
  {$IFDEF UNIX}
  Check(Trapper.Traps, 'threads made later have them, too');
  {$ENDIF}
  Trapper.Free;
  SetExceptionMask([exInvalidOp, exDenormalized, exZeroDivide, exOverflow, exUnderflow, exPrecision]);
  F.Segmentation.Undo;
  Check(not Traps, 'a program that masks them finds them masked');
  SetExceptionMask([exDenormalized, exUnderflow, exPrecision]);
  Check(Traps, 'and raises them again when it likes');
  F.Free;
end;

procedure TestCallbacks(const Scan, SmallScan: string);
begin
  TestProgress(Scan); // first: before the tests make a thread of their own
  TestControl(SmallScan);
  TestChange(SmallScan);
  TestLog(SmallScan);
  TestThreads(Scan, SmallScan);
end;

end.
