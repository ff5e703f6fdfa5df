// Every block of statuses as its exception, and what is left behind. SPDX-License-Identifier: Apache-2.0
unit test_errors;

{$MODE DELPHI}
{$IFDEF WINDOWS}{$CODEPAGE UTF8}{$ENDIF} // this file is; elsewhere that is what Free Pascal takes it for

interface

procedure TestErrors(const Scan, SmallScan, Folder: string);

implementation

uses
  SysUtils, Math, checks, fixture, toothseg, toothseg_api;

var
  F: TFixture;

procedure TestBlocks;

  procedure Block(First, Last: TTsStatus; Wanted: TErrorClass);
  var
    Status: TTsStatus;
  begin
    for Status := First to Last do
      try
        TsCheck(Status, 'text');
        Missed(IntToStr(Status));
      except
        on E: Exception do
          Check((E.ClassType = Wanted) and (E.Message = 'text'), Format('%d is %s', [Status, E.ClassName]));
      end;
  end;

begin
  Section('blocks');
  TsCheck(TS_OK);
  Block(TS_E_INVALID_ARGUMENT, TS_E_MISMATCH, ETsUsage);
  Block(TS_E_OUT_OF_MEMORY, TS_E_OUT_OF_MEMORY, ETsOutOfMemory);
  Block(TS_E_CANCELLED, TS_E_CANCELLED, ETsCancelled);
  Block(TS_E_INTERNAL, TS_E_INTERNAL, ETsSystem);
  Block(TS_E_FILE_OPEN, TS_E_FILE_NEWER, ETsFile);
  Block(TS_E_MESH_EMPTY, TS_E_MESH_TOO_LARGE, ETsIntake);
  Block(TS_E_NO_TEETH, TS_E_NO_CONSTRAINT, ETsFeatures);
  Block(TS_E_CLICK_OFF_SURFACE, TS_E_NO_HISTORY, ETsSegmentation);
  Block(TS_E_EDIT_NOTHING, TS_E_EDIT_NO_LOOP, ETsEdit);
  Block(TS_E_TOO_MANY_TEETH, TS_E_NUMBER_ORDER, ETsNumber);
  Block(TS_E_NOT_CLOSED, TS_E_NOT_CLOSED, ETsToothMesh);
  Block(800, 801, ETsError);
  try
    TsCheck(TS_E_NO_TEETH);
    Missed('no text');
  except
    on E: ETsError do
      Check((E.Message = 'TS_E_NO_TEETH') and (E.StatusName = 'TS_E_NO_TEETH'), 'the name stands for a text');
  end;
end;

procedure TestUsage(const SmallScan: string);
var
  Closed: TTsModel;
  Features: TTsFeatures;
  Other: TFixture;
  Options: TTsSegmentOptions;
begin
  Section('100');
  try TsFdiToUniversal(99); Missed('fdi') except on E: Exception do Raised(E, ETsUsage, TS_E_INVALID_ARGUMENT, 'fdi') end;
  try F.Segmentation.Tooth(9999); Missed('tooth') except on E: Exception do Raised(E, ETsUsage, TS_E_NOT_FOUND, 'tooth') end;
  try F.Segmentation.Contour(0, 9999); Missed('contour') except on E: Exception do Raised(E, ETsUsage, TS_E_NOT_FOUND, 'contour') end;
  try F.Model.Nearest(TsPoint(NaN, 0, 0)); Missed('NaN') except on E: Exception do Raised(E, ETsUsage, TS_E_INVALID_ARGUMENT, 'NaN') end;
  try TsMeshInput([0.0, 0.0, 0.0, 1.0], [0, 0, 0]); Missed('threes') except on E: Exception do Raised(E, ETsUsage, TS_E_INVALID_ARGUMENT, 'threes') end;
  Options := TsSegmentOptions;
  Options.StructSize := 0;
  try TTsSegmentation.Create(F.Features, Options); Missed('size') except on E: Exception do Raised(E, ETsUsage, TS_E_STRUCT_SIZE, 'size') end;
  Other := TFixture.Create(SmallScan, False);
  try
    try
      TTsSegmentation.ReadSession(Other.Model, F.Segmentation.WriteSession, Features);
      Missed('mismatch');
    except
      on E: Exception do
        Raised(E, ETsUsage, TS_E_MISMATCH, 'mismatch');
    end;
    Check(Features = nil, 'no features of a session that was refused');
  finally
    Other.Free;
  end;

  Section('closed');
  Closed := TTsModel.Load(F.Context, SmallScan);
  Check(not Closed.Closed, 'open');
  Closed.Close;
  Closed.Close;
  Check(Closed.Closed, 'closed');
  try Closed.Report; Missed('report') except on E: Exception do Raised(E, ETsClosed, TS_E_NULL, 'report') end;
  try Closed.Positions; Missed('positions') except on E: Exception do Raised(E, ETsClosed, TS_E_NULL, 'positions') end;
  try TTsFeatures.Detect(Closed); Missed('parent') except on E: Exception do Raised(E, ETsClosed, TS_E_NULL, 'parent') end;
  try TTsFeatures.Detect(nil); Missed('nil parent') except on E: Exception do Raised(E, ETsClosed, TS_E_NULL, 'nil parent') end;
  Closed.Free;
end;

procedure TestSystem(const SmallScan: string);
var
  Counting: TCountingAllocator;
  Memory: ITsAllocator;
  Context: TTsContext;
  Model: TTsModel;
  Job: TTsJob;
begin
  Section('200');
  Counting := TCountingAllocator.Create;
  Memory := Counting;
  Context := TTsContext.Create(0, nil, Memory);
  Model := nil;
  try
    Counting.FailFrom := Counting.Made + 5;
    try Model := TTsModel.Load(Context, SmallScan); Missed('memory') except on E: Exception do Raised(E, ETsOutOfMemory, TS_E_OUT_OF_MEMORY, 'memory') end;
    Counting.FailFrom := 0;
    Model := TTsModel.Load(Context, SmallScan);
    Counting.FailFrom := Counting.Made + 1;
    try TTsFeatures.Detect(Model); Missed('memory of features') except on E: Exception do Raised(E, ETsOutOfMemory, TS_E_OUT_OF_MEMORY, 'memory of features') end;
  finally
    Model.Free;
    Context.Free;
  end;
  Expect('blocks left by calls without memory', Counting.Live, 0);

  Job := TTsJob.Create(F.Context);
  try
    Job.Cancel;
    try TTsFeatures.Detect(F.Model, Job); Missed('cancelled') except on E: Exception do Raised(E, ETsCancelled, TS_E_CANCELLED, 'cancelled') end;
    Job.Reset;
    TTsFeatures.Detect(F.Model, Job).Free;
    Check(Job.Progress = 1, 'a job that was reset goes on');
  finally
    Job.Free;
  end;
end;

procedure TestFiles(const SmallScan, Folder: string);
var
  Bytes: TTsFlags;
  Text: AnsiString;
  Features: TTsFeatures;
begin
  Section('300');
  try TTsModel.Load(F.Context, Folder + 'nicht dä.ply'); Missed('open') except on E: Exception do begin
    Raised(E, ETsFile, TS_E_FILE_OPEN, 'open');
    Check(Pos('nicht dä.ply', E.Message) > 0, 'names are UTF-8: ' + E.Message) end end;
  Text := FileText(SmallScan);
  SetLength(Bytes, Length(Text) - 1);
  Move(Text[1], Bytes[0], Length(Bytes));
  try TTsModel.Read(F.Context, Bytes); Missed('truncated') except on E: Exception do Raised(E, ETsFile, TS_E_FILE_TRUNCATED, 'truncated') end;
  try TTsModel.Read(F.Context, [1, 2, 3]); Missed('format') except on E: Exception do Raised(E, ETsFile, TS_E_FILE_FORMAT, 'format') end;
  try F.Segmentation.Save(Folder + 'none/x.ply', TS_OUTPUT_PLY); Missed('write') except on E: Exception do Raised(E, ETsFile, TS_E_FILE_WRITE, 'write') end;
  try F.Segmentation.SaveSession(Folder + 'none/x.json'); Missed('session') except on E: Exception do Raised(E, ETsFile, TS_E_FILE_WRITE, 'session') end;
  try TTsSegmentation.ReadSession(F.Model, '{}', Features); Missed('no session') except on E: Exception do Raised(E, ETsFile, TS_E_FILE_FORMAT, 'no session') end;
end;

procedure TestMeshes;
const
  Triangle: array [0 .. 2] of Cardinal = (0, 1, 2);
  Wrong: array [0 .. 2] of Cardinal = (0, 1, 3);
var
  Positions: array [0 .. 8] of Double;
  None: array of Double;
  NoTriangle: array of Cardinal;
  I: Integer;
begin
  Section('400');
  for I := 0 to 8 do
    Positions[I] := 10 * ((I * I) mod 7);
  None := nil;
  NoTriangle := nil;
  try TTsModel.Create(F.Context, TsMeshInput(None, NoTriangle)); Missed('empty') except on E: Exception do Raised(E, ETsIntake, TS_E_MESH_EMPTY, 'empty') end;
  try TTsModel.Create(F.Context, TsMeshInput(Positions, Wrong)); Missed('range') except on E: Exception do Raised(E, ETsIntake, TS_E_MESH_INDEX_RANGE, 'range') end;
  TTsModel.Create(F.Context, TsMeshInput(Positions, Triangle)).Free;
  Positions[4] := NaN;
  try TTsModel.Create(F.Context, TsMeshInput(Positions, Triangle)); Missed('NaN') except on E: Exception do Raised(E, ETsIntake, TS_E_MESH_NON_FINITE, 'NaN') end;
  Positions[4] := 1e5;
  try TTsModel.Create(F.Context, TsMeshInput(Positions, Triangle)); Missed('units') except on E: Exception do Raised(E, ETsIntake, TS_E_MESH_UNITS, 'units') end;
end;

procedure TestFeatures;
const
  Plane: array [0 .. 11] of Single = (0, 0, 0, 60, 0, 0, 60, 60, 0, 0, 60, 0);
  Two: array [0 .. 5] of Cardinal = (0, 1, 2, 0, 2, 3);
var
  Flat: TTsModel;
  Empty: TTsFeatures;
begin
  Section('500');
  Flat := TTsModel.Create(F.Context, TsMeshInput(Plane, Two));
  try
    try TTsFeatures.Detect(Flat); Missed('teeth') except on E: Exception do Raised(E, ETsFeatures, TS_E_NO_TEETH, 'teeth') end;
    Empty := TTsFeatures.Create(Flat);
    try
      try TTsSegmentation.Create(Empty); Missed('points') except on E: Exception do Raised(E, ETsFeatures, TS_E_NO_CONSTRAINT, 'points') end;
    finally
      Empty.Free;
    end;
  finally
    Flat.Free;
  end;
end;

procedure TestSegmentation;
var
  Before: TTsIndices;
  Session: UTF8String;
  Tooth, Other: Cardinal;
  Cut: TTsCut;
  Far: TTsPoint;
  Options: TTsNumberOptions;
begin
  Tooth := F.Segmentation.Teeth[4];
  Other := F.Segmentation.Teeth[5];
  Far := TsPoint(500, 500, 500);
  F.Segmentation.AssignNumbers;
  F.Segmentation.Locked[Tooth] := True;
  Before := F.Segmentation.Labels;
  Session := F.Segmentation.WriteSession;

  Section('600');
  try F.Segmentation.Click(Far); Missed('off') except on E: Exception do Raised(E, ETsSegmentation, TS_E_CLICK_OFF_SURFACE, 'off') end;
  try F.Segmentation.Click(F.OnGingiva); Missed('gingiva') except on E: Exception do Raised(E, ETsSegmentation, TS_E_CLICK_ON_GINGIVA, 'gingiva') end;
  try F.Segmentation.Click(F.OnTooth(Tooth)); Missed('locked') except on E: Exception do Raised(E, ETsSegmentation, TS_E_LOCKED, 'locked') end;
  try F.Segmentation.RemoveTooth(Tooth); Missed('remove') except on E: Exception do Raised(E, ETsSegmentation, TS_E_LOCKED, 'remove') end;
  try F.Segmentation.Locked[Tooth] := True; Missed('twice') except on E: Exception do Raised(E, ETsSegmentation, TS_E_NO_CHANGE, 'twice') end;
  try F.Segmentation.MergeTeeth(Other, Other); Missed('itself') except on E: Exception do Raised(E, ETsSegmentation, TS_E_NO_CHANGE, 'itself') end;
  try F.Segmentation.Redo; Missed('redo') except on E: Exception do Raised(E, ETsSegmentation, TS_E_NO_HISTORY, 'redo') end;

  Section('650');
  Cut := F.Segmentation.Cut(Other);
  try F.Segmentation.OffsetCut(Other, 0); Missed('offset') except on E: Exception do Raised(E, ETsEdit, TS_E_EDIT_NOTHING, 'offset') end;
  try F.Segmentation.OffsetCut(Other, -5); Missed('loop') except on E: Exception do Raised(E, ETsEdit, TS_E_EDIT_NO_LOOP, 'loop') end;
  try F.Segmentation.DragCut(Other, 0, 0, Cut.Points[0].Position); Missed('drag') except on E: Exception do Raised(E, ETsEdit, TS_E_EDIT_NOTHING, 'drag') end;
  try F.Segmentation.DrawCut(Other, [Cut.Points[0].Position, Cut.Points[0].Position]); Missed('draw') except on E: Exception do Raised(E, ETsEdit, TS_E_EDIT_NOTHING, 'draw') end;

  Section('unchanged');
  Check(SameIndices(Before, F.Segmentation.Labels), 'labels');
  Check(Session = F.Segmentation.WriteSession, 'session');
  F.Segmentation.Locked[Tooth] := False;

  Section('700');
  F.Segmentation.SetNumber(Tooth, F.Segmentation.Number(Tooth).Fdi);
  try F.Segmentation.SetNumber(Other, F.Segmentation.Number(Tooth).Fdi); Missed('taken') except on E: Exception do Raised(E, ETsNumber, TS_E_NUMBER_TAKEN, 'taken') end;
  try F.Segmentation.SetNumber(Other, 36); Missed('jaw') except on E: Exception do Raised(E, ETsNumber, TS_E_NUMBER_JAW, 'jaw') end;
  Options := TsNumberOptions;
  Options.Jaw := TS_JAW_LOWER;
  try F.Segmentation.AssignNumbers(Options); Missed('jaw given') except on E: Exception do Raised(E, ETsNumber, TS_E_NUMBER_JAW, 'jaw given') end;
  F.Segmentation.SetNumber(Tooth, 0);
  Check(SameIndices(Before, F.Segmentation.Labels), 'labels after numbers');
end;

procedure TestErrors(const Scan, SmallScan, Folder: string);
begin
  F := TFixture.Create(Scan);
  try
    TestBlocks;
    TestUsage(SmallScan);
    TestSystem(SmallScan);
    TestFiles(SmallScan, Folder);
    TestMeshes;
    TestFeatures;
    TestSegmentation;
  finally
    F.Free;
  end;
end;

end.
