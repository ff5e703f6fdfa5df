// A separated arch, and a memory hook that counts. SPDX-License-Identifier: Apache-2.0
unit fixture;

{$MODE DELPHI}

interface

uses
  SysUtils, Classes, toothseg, toothseg_api;

type
  TFixture = class
  public
    Context: TTsContext;
    Model: TTsModel;
    Features: TTsFeatures;
    Segmentation: TTsSegmentation;
    constructor Create(const Scan: string; Separate: Boolean = True);
    destructor Destroy; override;
    // A point on the surface, on the tooth with this id: the middle of its first feature point.
    function OnTooth(Tooth: Cardinal): TTsPoint;
    // The vertex that is furthest from the biting surface.
    function OnGingiva: TTsPoint;
  end;

  TCountingAllocator = class(TInterfacedObject, ITsAllocator)
  public
    Live: Integer; // blocks not given back
    Made: Integer; // blocks ever
    FailFrom: Integer; // the block from which on there is no memory; 0: never
    function Allocate(Bytes: NativeUInt): Pointer;
    procedure Release(Memory: Pointer);
  end;

function SameIndices(const A, B: TTsIndices): Boolean;
function SameBytes(const A, B: string): Boolean; // of two files
function FileText(const Path: string): AnsiString;

implementation

constructor TFixture.Create(const Scan: string; Separate: Boolean);
begin
  Context := TTsContext.Create;
  Model := TTsModel.Load(Context, Scan);
  Features := TTsFeatures.Detect(Model);
  Segmentation := TTsSegmentation.Create(Features);
  if Separate then
    Segmentation.SegmentAll;
end;

destructor TFixture.Destroy;
begin
  Segmentation.Free;
  Features.Free;
  Model.Free;
  Context.Free;
  inherited;
end;

function TFixture.OnTooth(Tooth: Cardinal): TTsPoint;
var
  Point: TTsFeaturePoint;
begin
  for Point in Features.Points do
    if Point.Group = Tooth then
      Exit(Point.Position);
  raise Exception.Create('no such tooth');
end;

function TFixture.OnGingiva: TTsPoint;
var
  Up, Point: TTsPoint;
  Lowest, Height: Double;
begin
  Up := Features.Occlusal;
  Lowest := 1e9;
  for Point in Model.Positions do
  begin
    Height := Point[0] * Up[0] + Point[1] * Up[1] + Point[2] * Up[2];
    if Height < Lowest then
    begin
      Lowest := Height;
      Result := Point;
    end;
  end;
end;

const
  Alignment = 16;

// Before each block is where it really begins.
function TCountingAllocator.Allocate(Bytes: NativeUInt): Pointer;
var
  Whole: Pointer;
begin
  if (InterlockedIncrement(Made) >= FailFrom) and (FailFrom > 0) then
    Exit(nil);
  Whole := GetMem(Bytes + 2 * Alignment);
  Result := Pointer((PtrUInt(Whole) + 2 * Alignment) and not PtrUInt(Alignment - 1));
  PPointer(Result)[-1] := Whole;
  InterlockedIncrement(Live);
end;

procedure TCountingAllocator.Release(Memory: Pointer);
begin
  if Memory = nil then
    Exit;
  FreeMem(PPointer(Memory)[-1]);
  InterlockedDecrement(Live);
end;

function SameIndices(const A, B: TTsIndices): Boolean;
begin
  Result := (Length(A) = Length(B)) and ((A = nil) or CompareMem(@A[0], @B[0], Length(A) * SizeOf(Cardinal)));
end;

function FileText(const Path: string): AnsiString;
var
  Stream: TMemoryStream;
begin
  Stream := TMemoryStream.Create;
  try
    Stream.LoadFromFile(Path);
    SetString(Result, PAnsiChar(Stream.Memory), Stream.Size);
  finally
    Stream.Free;
  end;
end;

function SameBytes(const A, B: string): Boolean;
begin
  Result := FileText(A) = FileText(B);
end;

end.
