// Lifetimes: any order, nothing left behind. SPDX-License-Identifier: Apache-2.0
unit test_objects;

{$MODE DELPHI}

interface

procedure TestObjects(const SmallScan: string);

implementation

uses
  SysUtils, checks, fixture, toothseg, toothseg_api;

type
  TObserved = class
    Name: string;
    constructor Create(const AName: string);
    destructor Destroy; override;
  end;

  TListener = class
    Calls: Integer;
    function Progress(Fraction: Double; const Stage: string): Boolean;
    procedure Log(Level: TTsLogLevel; const Text: string);
    procedure Change(const Teeth: TTsIndices);
  end;

var
  Order: string;
  Scan: string;

constructor TObserved.Create(const AName: string);
begin
  Name := AName;
end;

destructor TObserved.Destroy;
begin
  Order := Order + Name;
  inherited;
end;

function TListener.Progress(Fraction: Double; const Stage: string): Boolean;
begin
  Inc(Calls);
  Result := True;
end;

procedure TListener.Log(Level: TTsLogLevel; const Text: string);
begin
  InterlockedIncrement(Calls);
end;

procedure TListener.Change(const Teeth: TTsIndices);
begin
  Inc(Calls);
end;

// Makes one of each, and frees them in the order of Which: a letter an object.
procedure InOrder(const Which: string; const Memory: ITsAllocator; Listener: TListener);
var
  Context: TTsContext;
  Job: TTsJob;
  Model: TTsModel;
  Features, Copied, Resumed: TTsFeatures;
  Segmentation, Again: TTsSegmentation;
  Mesh: TTsMesh;
  Letter: Char;
begin
  Context := TTsContext.Create(0, Listener.Log, Memory);
  Job := TTsJob.Create(Context, Listener.Progress);
  Model := TTsModel.Load(Context, Scan, Job);
  Features := TTsFeatures.Detect(Model, Job);
  Copied := Features.Clone;
  Segmentation := TTsSegmentation.Create(Copied, Job);
  Segmentation.OnChange := Listener.Change;
  Segmentation.Click(Segmentation.ProposeClicks[0], Job);
  Mesh := TTsMesh.OfTooth(Segmentation, Segmentation.Teeth[0], Job);
  Again := TTsSegmentation.ReadSession(Model, Segmentation.WriteSession, Resumed, Job);
  for Letter in Which do
    case Letter of
      'c': Context.Free;
      'j': Job.Free;
      'm': Model.Free;
      'f': begin
          Features.Free;
          Copied.Free;
          Resumed.Free;
        end;
      's': begin
          if Pos('s', Which) < Pos('t', Which) then
            Check(Mesh.Info.Triangles > 0, 'a mesh outlives what it was made from');
          Segmentation.Free;
          Again.Free;
        end;
      't': Mesh.Free;
    end;
end;

procedure TestOrder;
const
  Orders: array [0 .. 3] of string = ('tsfmjc', 'cjmfst', 'mctjfs', 'sfcmtj');
  Rounds = 24;
var
  Counting: TCountingAllocator;
  Memory: ITsAllocator;
  Listener: TListener;
  Which: string;
  Before: PtrUInt;
  I: Integer;
begin
  Section('order');
  Counting := TCountingAllocator.Create;
  Memory := Counting;
  Listener := TListener.Create;
  for Which in Orders do
  begin
    InOrder(Which, Memory, Listener);
    Expect('blocks left after ' + Which, Counting.Live, 0);
  end;
  Check(Counting.Made > 0, 'the allocator was asked');
  Check(Listener.Calls > 0, 'the listener was called');

  Section('leaks');
  Before := GetFPCHeapStatus.CurrHeapUsed;
  for I := 1 to Rounds do
    InOrder('tsfmjc', Memory, Listener);
  Expect('blocks of the library left', Counting.Live, 0);
  Check(GetFPCHeapStatus.CurrHeapUsed <= Before + 1024,
    Format('bytes of Pascal left: %d', [Int64(GetFPCHeapStatus.CurrHeapUsed) - Int64(Before)]));
  Listener.Free;
end;

procedure TestRefused;
var
  Context: TTsContext;
  Counting: TCountingAllocator;
  Memory: ITsAllocator;
  Before: PtrUInt;
  I: Integer;
begin
  Counting := TCountingAllocator.Create;
  Memory := Counting;
  Context := TTsContext.Create(0, nil, Memory);
  Before := 0;
  for I := 0 to 24 do
  begin
    if I = 1 then
      Before := GetFPCHeapStatus.CurrHeapUsed;
    try
      TTsModel.Load(Context, 'no such file');
    except
      on ETsFile do
        ;
    end;
  end;
  Check(GetFPCHeapStatus.CurrHeapUsed <= Before + 256, 'a constructor that raises leaves nothing');
  Context.Free;
  Expect('blocks left by them', Counting.Live, 0);
end;

procedure Forgetful;
var
  Keep: ITsKeeper;
begin
  Keep := TsKeeper;
  Keep.Add(TObserved.Create('first '));
  Keep.Add(TObserved.Create('second '));
  raise EAbort.Create('on the way');
end;

procedure TestKeeper;
begin
  Section('keeper');
  try
    Forgetful;
  except
    on EAbort do
      Order := Order + 'handler';
  end;
  Check(Order = 'second first handler', 'the last is freed first, and before the handler: ' + Order);
end;

procedure TestObjects(const SmallScan: string);
begin
  Scan := SmallScan;
  TestOrder;
  TestRefused;
  TestKeeper;
end;

end.
