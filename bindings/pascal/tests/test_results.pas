// Every call that gives something, and what it has to agree with. SPDX-License-Identifier: Apache-2.0
unit test_results;

{$MODE DELPHI}

interface

// Labels: what ts-segment wrote for the scan.
procedure TestResults(const Scan, Labels, Folder: string);

implementation

uses
  SysUtils, Classes, Math, checks, fixture, toothseg, toothseg_api;

var
  F: TFixture;
  S: TTsSegmentation;

function Distance(const A, B: TTsPoint): Double;
begin
  Result := Sqrt(Sqr(A[0] - B[0]) + Sqr(A[1] - B[1]) + Sqr(A[2] - B[2]));
end;

function Rises(const Values: TTsStatuses): Boolean;
var
  Status: TTsStatus;
begin
  Result := Values <> nil;
  for Status in Values do
    Result := Result and (Status = TS_OK);
end;

procedure TestLabels(const Labels: string);
var
  Wanted: TStringList;
  Mine, Again: TTsIndices;
  I, Wrong: Integer;
begin
  Section('labels');
  Check(Rises(S.Clicks(S.ProposeClicks)), 'all clicks are good');
  Expect('nothing is left to click', Length(S.ProposeClicks), 0);
  Wanted := TStringList.Create;
  Wanted.LoadFromFile(Labels);
  Mine := S.Labels;
  Expect('number of labels', Length(Mine), Wanted.Count);
  Wrong := 0;
  for I := 0 to Min(High(Mine), Wanted.Count - 1) do
    if IntToStr(Mine[I]) <> Wanted[I] then
      Inc(Wrong);
  Expect('labels that are not those of ts-segment', Wrong, 0);
  Wanted.Free;
  Again := nil;
  S.ReadLabels(Again);
  Check(SameIndices(Mine, Again), 'read into an array');
  S.ReadLabels(Again);
  Check(SameIndices(Mine, Again), 'and into the same one again');
  Expect('clicks', S.ClickCount, 7);
  Expect('none of none', Length(S.Clicks([])), 0);
end;

procedure TestModel(const Scan, Folder: string);
var
  Report: TTsIntakeReport;
  Positions: TTsPoints;
  Triangles: TTsTriangles;
  Same: TTsModel;
  Flat: array of Single;
  Indices: array of Cardinal;
  Text: AnsiString;
  Bytes: TTsFlags;
  Options: TTsIntakeOptions;
  Point: TTsSurfacePoint;
  I, K: Integer;
begin
  Section('model');
  Report := F.Model.Report;
  Positions := F.Model.Positions;
  Triangles := F.Model.Triangles;
  Expect('vertices', Length(Positions), Report.Vertices);
  Expect('faces', Length(Triangles), Report.Faces);
  Expect('face sources', Length(F.Model.FaceSources), Report.Faces);
  Expect('vertex map', Length(F.Model.VertexMap), Report.InputVertices);
  Check((Report.Area > 500) and (Report.Diagonal > 30), 'the size of an arch');
  Point := F.Model.Nearest(Positions[17]);
  Check(Distance(Point.Position, Positions[17]) < 1e-9, 'a vertex is nearest to itself');
  Expect('its index', Point.NearestVertex, 17);
  for I := 0 to 2 do
    Positions[0][I] := Point.Position[I] + 20 * F.Features.Occlusal[I];
  Point := F.Model.Raycast(Positions[0], TsPoint(-F.Features.Occlusal[0], -F.Features.Occlusal[1], -F.Features.Occlusal[2]));
  Check((Point.Distance > 0) and (Point.Distance < 40), 'a ray from above hits');
  try F.Model.Raycast(TsPoint(900, 900, 900), TsPoint(1, 1, 1)); Missed('ray') except on E: Exception do Raised(E, ETsUsage, TS_E_NOT_FOUND, 'a ray that misses') end;

  Positions := F.Model.Positions;
  Same := TTsModel.Create(F.Context, TsMeshInput(Positions, Triangles));
  Expect('faces from arrays of points', Same.Report.Faces, Report.Faces);
  Same.Free;
  SetLength(Flat, 3 * Length(Positions));
  SetLength(Indices, 3 * Length(Triangles));
  for I := 0 to High(Positions) do
    for K := 0 to 2 do
      Flat[3 * I + K] := Positions[I][K] / 25.4;
  for I := 0 to High(Triangles) do
    for K := 0 to 2 do
      Indices[3 * I + K] := Triangles[I][K];
  Options := TsIntakeOptions;
  Check(Options.Unit_ = TS_UNIT_CHECKED_MM, 'the default unit');
  Options.Unit_ := TS_UNIT_INCH;
  Same := TTsModel.Create(F.Context, TsMeshInput(Flat, Indices), Options);
  Check(Abs(Same.Report.Diagonal - Report.Diagonal) < 1e-3, 'inches');
  Same.Free;
  Text := FileText(Scan);
  SetLength(Bytes, Length(Text));
  Move(Text[1], Bytes[0], Length(Bytes));
  Same := TTsModel.Read(F.Context, Bytes, TS_FORMAT_PLY);
  Expect('faces from memory', Same.Report.Faces, Report.Faces);
  Same.Free;
  with TFileStream.Create(Folder + 'zähne.ply', fmCreate) do
  begin
    WriteBuffer(Text[1], Length(Text));
    Free;
  end;
  Same := TTsModel.Load(F.Context, Folder + 'zähne.ply');
  Expect('faces from a file with an umlaut', Same.Report.Faces, Report.Faces);
  Same.Free;
end;

procedure TestFeatures;
var
  Mine: TTsFeatures;
  Info: TTsFeaturesInfo;
  Options: TTsFeatureOptions;
  Point, Group: Cardinal;
begin
  Section('features');
  Info := F.Features.Info;
  Expect('points', Length(F.Features.Points), Info.Points);
  Expect('groups', Length(F.Features.Groups), Info.Groups);
  Check(Length(F.Features.Arch) > 10, 'arch');
  Mine := F.Features.Clone;
  Point := Mine.AddPoint(F.OnGingiva);
  Expect('a new group', Mine.Info.Groups, Info.Groups + 1);
  Mine.MovePoint(Point, F.OnTooth(F.Features.Groups[0].Id));
  Group := Mine.SetGroup(Point, F.Features.Groups[0].Id);
  Expect('its group', Group, F.Features.Groups[0].Id);
  Expect('the new group is gone', Mine.Info.Groups, Info.Groups);
  Mine.RemovePoint(Point);
  Expect('points as before', Mine.Info.Points, Info.Points);
  Mine.RemoveGroup(Group);
  Expect('a group less', Mine.Info.Groups, Info.Groups - 1);
  Mine.Occlusal := TsPoint(0, 0, 2);
  Check((Mine.Occlusal[0] = 0) and (Mine.Occlusal[2] = 1), 'a direction set, of length 1');
  Mine.Free;
  Options := TsFeatureOptions;
  Options.MaxPoints := 1;
  Mine := TTsFeatures.Detect(F.Model, Options);
  Check(Mine.Info.Points < Info.Points, 'fewer points where fewer are asked for');
  Mine.Free;
end;

procedure TestClick;
var
  Info: TTsClickInfo;
  Infos: TTsContourInfos;
  Lines: TTsPolylines;
  Field: TTsValues;
  Bin, All: Cardinal;
  Points, I, Widest: Integer;
begin
  Section('click');
  Info := S.ClickInfo(0);
  Check(S.Tooth(Info.Target).Click < S.ClickCount, 'the click of its tooth');
  Field := S.Field(0);
  Expect('field', Length(Field), F.Model.Report.Vertices);
  Check((MinValue(Field) >= -1e-6) and (MaxValue(Field) <= 1 + 1e-6), 'from 0 to 1');
  All := 0;
  for Bin in S.Histogram(0) do
    Inc(All, Bin);
  Expect('histogram', All, Length(Field));
  Infos := S.Contours(0);
  Expect('contours', Length(Infos), TsSegmentOptions.Contours);
  Widest := 0;
  for I := 0 to High(Infos) do
    if Infos[I].Polylines > Infos[Widest].Polylines then
      Widest := I;
  Lines := S.Contour(0, Widest);
  Expect('polylines', Length(Lines), Infos[Widest].Polylines);
  Points := 0;
  for I := 0 to High(Lines) do
    Inc(Points, Length(Lines[I].Points));
  Expect('points of a contour', Points, Infos[Widest].Points);
end;

procedure TestTeeth;
var
  Tooth: Cardinal;
  Info: TTsToothInfo;
  Cut: TTsCut;
  Frame: TTsToothFrame;
  Item: TTsReviewItem;
  Length_: Double;
  I: Integer;
begin
  Section('teeth');
  Expect('teeth', Length(S.Teeth), 14);
  for Tooth in S.Teeth do
  begin
    Info := S.Tooth(Tooth);
    Expect('id', Info.Id, Tooth);
    Expect('faces', Length(S.ToothFaces(Tooth)), Info.Faces);
    Expect('vertices', Length(S.ToothVertices(Tooth)), Info.Vertices);
    Expect('seeds', Length(S.ToothSeeds(Tooth)), Info.Seeds);
    Cut := S.Cut(Tooth);
    Expect('points of the cut', Length(Cut.Points), Cut.Info.Points);
    Length_ := 0;
    for I := 1 to High(Cut.Points) do
      Length_ := Length_ + Distance(Cut.Points[I - 1].Position, Cut.Points[I].Position);
    Length_ := Length_ + Distance(Cut.Points[High(Cut.Points)].Position, Cut.Points[0].Position);
    Check(Abs(Length_ - Cut.Info.Length) < 1e-6, 'length of the cut');
    Frame := S.ToothFrame(Tooth);
    Check((Frame.Width > 2) and (Frame.Height > 2), 'the size of a tooth');
  end;
  for Item in S.Review do
    Check((Item.Confidence < 0.9) or (Item.Warnings <> 0), 'a tooth of the review wants a look');
  Check(S.Review[0].Tooth <> S.Review[High(S.Review)].Tooth, 'review');
  Check(S.Overlaps = nil, 'overlaps');
  Check((S.Memory.Model > 0) and (S.Memory.Factor <= S.Memory.FactorWhole), 'memory');
  Check(S.PrepareTimes.Features > 0, 'times');
end;

procedure TestNumbers;
var
  Options: TTsNumberOptions;
  Palmer: TTsPalmer;
  Fdi: Cardinal;
begin
  Section('numbers');
  S.AssignNumbers;
  Check(S.Jaw.Jaw = TS_JAW_UPPER, 'jaw');
  Fdi := S.Number(S.Teeth[0]).Fdi;
  Check((Fdi = 17) or (Fdi = 27), 'the number of a second molar');
  Options := TsNumberOptions;
  Options.Mirrored := 1;
  S.AssignNumbers(Options);
  Expect('mirrored', S.Number(S.Teeth[0]).Fdi, 44 - Fdi);
  Expect('universal', TsFdiToUniversal(16), 3);
  Expect('and back', TsUniversalToFdi(3), 16);
  Palmer := TsFdiToPalmer(16);
  Check((AnsiString(Palmer.Letters) = 'UR6') and (Palmer.Quadrant = 1) and (Palmer.Position = 6), 'Palmer');
end;

// A step, its change, and that it can be taken back.
procedure TakeBack(const Before: TTsIndices; const What: string);
begin
  Check(not SameIndices(Before, S.Labels), What + ' changes something');
  Check(S.Changes <> nil, What + ' tells what');
  S.Undo;
  Check(SameIndices(Before, S.Labels), What + ' can be taken back');
end;

procedure TestCorrections;
var
  Before: TTsIndices;
  Teeth: TTsIndices;
  Tooth, Molar, Second: Cardinal;
  Cut: TTsCut;
  Up, Target, Part: TTsPoint;
  Point: TTsFeaturePoint;
  Stroke: TTsPoints;
  Seeds: TTsIndices;
  I, Lowest: Integer;
begin
  Section('corrections');
  Before := S.Labels;
  Teeth := S.Teeth;
  Tooth := Teeth[4];
  Molar := Teeth[1];
  Up := F.Features.Occlusal;
  Cut := S.Cut(Tooth);
  Lowest := 0;
  for I := 0 to High(Cut.Points) do
    if Cut.Points[I].Position[2] * Up[2] < Cut.Points[Lowest].Position[2] * Up[2] then
      Lowest := I;
  for I := 0 to 2 do
    Target[I] := Cut.Points[Lowest].Position[I] - 0.8 * Up[I];
  S.IncludePoint(Tooth, Target);
  TakeBack(Before, 'include');
  S.ExcludePoint(Tooth, Cut.Points[Lowest].Position);
  TakeBack(Before, 'exclude');
  Part := F.OnTooth(Molar);
  for Point in F.Features.Points do
    if (Point.Group = Molar) and (Distance(Point.Position, F.OnTooth(Molar)) > Distance(Part, F.OnTooth(Molar))) then
      Part := Point.Position;
  Second := S.SplitTooth(Molar, F.OnTooth(Molar), Part);
  Check(S.Tooth(Second).Area > 0, 'split makes a tooth');
  TakeBack(Before, 'split');
  S.MergeTeeth(Tooth, Teeth[5]);
  Expect('merge leaves one less', Length(S.Teeth), 13);
  TakeBack(Before, 'merge');
  S.RemoveTooth(Tooth);
  TakeBack(Before, 'remove');
  S.Redo;
  S.Undo;
  Seeds := S.ToothSeeds(Tooth);
  S.MovePoint(Tooth, F.OnTooth(Tooth), TsPoint(F.OnTooth(Tooth)[0] - 0.9 * Up[0], F.OnTooth(Tooth)[1] - 0.9 * Up[1],
    F.OnTooth(Tooth)[2] - 0.9 * Up[2]));
  Check(not SameIndices(Seeds, S.ToothSeeds(Tooth)), 'move changes the seeds');
  S.Undo;
  Check(SameIndices(Seeds, S.ToothSeeds(Tooth)), 'and they come back');
  Check(not S.Locked[Tooth], 'unlocked');
  S.Locked[Tooth] := True;
  Check(S.Locked[Tooth], 'locked');
  S.Undo;

  Section('edits');
  S.DragCut(Tooth, 0, Lowest, Target);
  Expect('an edit', Length(S.CutEdits(Tooth)), 1);
  Check(S.CutEdits(Tooth)[0].Kind = TS_EDIT_DRAG, 'a drag');
  S.OffsetCut(Tooth, 0.3);
  S.SmoothCut(Tooth, 0.5);
  Expect('edits', Length(S.CutEdits(Tooth)), 3);
  S.ResetCut(Tooth);
  Expect('no edits', Length(S.CutEdits(Tooth)), 0);
  Check(SameIndices(Before, S.Labels), 'reset');
  Cut := S.Cut(Tooth);
  SetLength(Stroke, 3);
  Stroke[0] := Cut.Points[(Lowest + Length(Cut.Points) - 6) mod Length(Cut.Points)].Position;
  Stroke[1] := Target;
  Stroke[2] := Cut.Points[(Lowest + 6) mod Length(Cut.Points)].Position;
  S.DrawCut(Tooth, Stroke);
  Check(S.CutEdits(Tooth)[0].Kind = TS_EDIT_DRAW, 'a stroke');
  S.ResetCut(Tooth);
  Check(S.History.Undo > 0, 'history');
  S.HistoryLimit := 1 shl 20;
  Expect('its limit', S.HistoryLimit, 1 shl 20);
end;

procedure TestMeshes(const Folder: string);
var
  Mesh, Gum: TTsMesh;
  Closed: TTsToothMeshOptions;
  Whole: TTsSaveOptions;
  Info: TTsMeshInfo;
begin
  Section('meshes');
  Closed := TsToothMeshOptions;
  Closed.Closed := 1;
  Mesh := TTsMesh.OfTooth(S, S.Teeth[3], Closed);
  Info := Mesh.Info;
  Expect('closed', Info.OpenRims, 0);
  Check(Info.Volume > 0, 'volume');
  Expect('label', Info.Label_, S.Tooth(S.Teeth[3]).Label_);
  Expect('positions', Length(Mesh.Positions), Info.Vertices);
  Expect('normals', Length(Mesh.Normals), Info.Vertices);
  Expect('flags', Length(Mesh.VertexFlags), Info.Vertices);
  Expect('triangles', Length(Mesh.Triangles), Info.Triangles);
  Expect('faces', Length(Mesh.Faces), Info.Triangles);
  Expect('of the fill', Mesh.Faces[Info.Triangles - 1], TS_NONE);
  Mesh.Save(Folder + 'tooth.stl', TS_OUTPUT_STL);
  Expect('bytes of STL', Length(FileText(Folder + 'tooth.stl')), 84 + 50 * Int64(Info.Triangles));
  Mesh.Free;
  Mesh := TTsMesh.OfTooth(S, S.Teeth[3]);
  Check(Mesh.Info.OpenRims > 0, 'open');
  Mesh.Free;
  Gum := TTsMesh.OfGingiva(S);
  Expect('gingiva', Gum.Info.Label_, 0);
  Gum.Free;
  Gum := TTsMesh.OfGingiva(S, TsToothMeshOptions);
  Gum.Free;
  S.Save(Folder + 'cut.ply', TS_OUTPUT_PLY);
  Whole := TsSaveOptions;
  Whole.WholeFaces := 1;
  S.Save(Folder + 'whole.ply', TS_OUTPUT_PLY, Whole);
  Check(Length(FileText(Folder + 'cut.ply')) > Length(FileText(Folder + 'whole.ply')), 'cut faces are more');
end;

procedure TestSession(const Folder: string);
var
  Again: TTsSegmentation;
  Features: TTsFeatures;
begin
  Section('session');
  Again := TTsSegmentation.ReadSession(F.Model, S.WriteSession, Features);
  Check(SameIndices(Again.Labels, S.Labels), 'from text');
  Expect('its features', Features.Info.Points, F.Features.Info.Points);
  Features.Free;
  Again.Free;
  S.SaveSession(Folder + 'session.json');
  Check(FileText(Folder + 'session.json') = S.WriteSession, 'a file is the same text');
  Again := TTsSegmentation.LoadSession(F.Model, Folder + 'session.json', Features);
  Check(SameIndices(Again.Labels, S.Labels), 'from a file');
  Features.Free;
  Again.Free;
end;

procedure TestOptions;
var
  Options: TTsSegmentOptions;
  Paper: TTsSegmentation;
begin
  Section('options');
  Options := TsSegmentOptions;
  Check((Options.Weights = TS_WEIGHTS_CONCAVITY) and (Options.ClickReach = 2), 'default');
  Options := TsSegmentOptions(TS_PRESET_PAPER);
  Check((Options.Weights = TS_WEIGHTS_PAPER) and (Options.SeedRadius = 0), 'paper');
  Paper := TTsSegmentation.Create(F.Features, Options);
  Check(Paper.Teeth = nil, 'nothing separated so far');
  Paper.Free;
  Check(TsVersion <> '', 'version');
  Check(TsStatusName(TS_E_NO_TEETH) = 'TS_E_NO_TEETH', 'name');
end;

procedure TestResults(const Scan, Labels, Folder: string);
begin
  F := TFixture.Create(Scan, False);
  S := F.Segmentation;
  try
    TestLabels(Labels);
    TestModel(Scan, Folder);
    TestFeatures;
    TestClick;
    TestTeeth;
    TestNumbers;
    TestCorrections;
    TestMeshes(Folder);
    TestSession(Folder);
    TestOptions;
  finally
    F.Free;
  end;
end;

end.
