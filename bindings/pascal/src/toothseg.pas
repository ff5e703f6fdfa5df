// toothseg for Pascal: separate the teeth of a scanned dental arch. bindings/pascal/README.md begins at the beginning.
// SPDX-License-Identifier: Apache-2.0
//
// Way of work  TTsContext -> TTsModel -> TTsFeatures -> TTsSegmentation, clicks -> labels, cuts, TTsMesh. Each object is
//              freed by its owner, in any order; Close gives back what it holds while the object stays.
// Units        millimetres, in the axes of the caller's mesh. Indices count from 0; TS_NONE is none.
// Errors       exceptions below ETsError, one class a block of statuses. An object that a call failed on is as it was.
// Callbacks    methods. What they raise comes out of the call that was under way. They come from threads of the library:
//              on Unix, Free Pascal wants cthreads as the first unit of a program that has any.
// Threads      what only reads an object may run on several threads at once; what changes one needs it to itself.
// Constants    TS_UNIT_MM and the like, and what each function and field is in full: toothseg_api.pas.
unit toothseg;

{$IFDEF FPC}
{$MODE DELPHI}
{$ENDIF}
{$TYPEDADDRESS OFF}

interface

uses
  SysUtils, toothseg_api, toothseg_fpu;

type
  // The records and enumerations of the C interface, by names of this unit.
  TTsStatus = ts_status;
  TTsLogLevel = ts_log_level;
  TTsFileFormat = ts_file_format;
  TTsOutputFormat = ts_output_format;
  TTsPreset = ts_preset;
  TTsMeshInput = ts_mesh_input;
  TTsIntakeOptions = ts_intake_options;
  TTsIntakeReport = ts_intake_report;
  TTsSurfacePoint = ts_surface_point;
  TTsFeatureOptions = ts_feature_options;
  TTsFeaturesInfo = ts_features_info;
  TTsFeaturePoint = ts_feature_point;
  TTsFeatureGroup = ts_feature_group;
  TTsSegmentOptions = ts_segment_options;
  TTsClickInfo = ts_click_info;
  TTsContourInfo = ts_contour_info;
  TTsEdgePoint = ts_edge_point;
  TTsToothInfo = ts_tooth_info;
  TTsCutInfo = ts_cut_info;
  TTsCutEdit = ts_cut_edit;
  TTsReviewItem = ts_review_item;
  TTsOverlap = ts_overlap;
  TTsHistoryInfo = ts_history_info;
  TTsPrepareTimes = ts_prepare_times;
  TTsMemoryInfo = ts_memory_info;
  TTsNumberOptions = ts_number_options;
  TTsNumberInfo = ts_number_info;
  TTsJawInfo = ts_jaw_info;
  TTsPalmer = ts_palmer;
  TTsToothFrame = ts_tooth_frame;
  TTsToothMeshOptions = ts_tooth_mesh_options;
  TTsMeshInfo = ts_mesh_info;
  TTsSaveOptions = ts_save_options;

  TTsPoint = ts_double3; // x, y, z in mm
  TTsTriangle = array [0 .. 2] of Cardinal;

  TTsIndices = TArray<Cardinal>;
  TTsStatuses = TArray<TTsStatus>;
  TTsValues = TArray<Double>;
  TTsFlags = TArray<Byte>;
  TTsPoints = TArray<TTsPoint>;
  TTsTriangles = TArray<TTsTriangle>;
  TTsFeaturePoints = TArray<TTsFeaturePoint>;
  TTsFeatureGroups = TArray<TTsFeatureGroup>;
  TTsContourInfos = TArray<TTsContourInfo>;
  TTsEdgePoints = TArray<TTsEdgePoint>;
  TTsCutEdits = TArray<TTsCutEdit>;
  TTsReview = TArray<TTsReviewItem>;
  TTsOverlaps = TArray<TTsOverlap>;

  TTsPolyline = record
    Points: TTsEdgePoints;
    Closed: Boolean; // the last point is joined to the first
  end;
  TTsPolylines = TArray<TTsPolyline>;

  TTsCut = record
    Info: TTsCutInfo;
    Points: TTsEdgePoints;
  end;

  // ---------------------------------------------------------------------------------------------------------- errors

  // What a call failed with. Message: what was wrong, and where, in one line.
  ETsError = class(Exception)
  private
    FStatus: TTsStatus;
    function GetStatusName: string;
  public
    constructor Create(Status: TTsStatus; const Text: string);
    property Status: TTsStatus read FStatus;
    property StatusName: string read GetStatusName; // 'TS_E_NO_TEETH'
  end;

  ETsUsage = class(ETsError); // 100: a bug in the calling program
  ETsClosed = class(ETsUsage); // an object that was closed, or nil, was used
  ETsSystem = class(ETsError); // 200: the surroundings
  ETsOutOfMemory = class(ETsSystem);
  ETsCancelled = class(ETsSystem);
  ETsFile = class(ETsError); // 300
  ETsIntake = class(ETsError); // 400: the mesh
  ETsFeatures = class(ETsError); // 500
  ETsSegmentation = class(ETsError); // 600: clicks and corrections
  ETsEdit = class(ETsError); // 650: edits of a cut
  ETsNumber = class(ETsError); // 700: numbers of teeth
  ETsToothMesh = class(ETsError); // 750: the meshes of teeth

  // ------------------------------------------------------------------------------------------------------- callbacks

  // Progress of a long call, from a thread that works for it. False cancels the call; so does an exception. It must not
  // call the library.
  TTsProgressEvent = function(Fraction: Double; const Stage: string): Boolean of object;
  // A line of the log, from any thread that works for the context.
  TTsLogEvent = procedure(Level: TTsLogLevel; const Text: string) of object;
  // Teeth have changed: on the thread of the call that changed them. It may read the segmentation, and must not change it.
  TTsChangeEvent = procedure(const Teeth: TTsIndices) of object;

  // Memory for the library's large buffers, asked for and given back on any thread.
  ITsAllocator = interface
    ['{8E0B5E0C-5C1B-4E0E-9B43-0C3D1B8C7A51}']
    function Allocate(Bytes: NativeUInt): Pointer; // at a multiple of 16; nil where there is none
    procedure Release(Memory: Pointer);
  end;

  // --------------------------------------------------------------------------------------------------------- objects

  // A context's hooks. The library calls them while any object of the context lives, so every object holds them.
  ITsHooks = interface
    ['{0B3F0E4A-9F0E-4B57-8E0C-2F1C5B9E7D11}']
    function TakeRaised: TObject;
  end;

  TTsJob = class;

  // What all objects have: a handle of the library, which Close, or else the destructor, gives back.
  TTsObject = class
  private
    FHandle: Pointer;
    FHooks: ITsHooks;
    FHost: TTsFpu; // what callbacks run with: that of the thread that made the context
    function GetClosed: Boolean;
    function Enter(Job: TTsJob = nil): TTsFpu;
    procedure Leave(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob = nil);
    function Call(Get: Pointer; const Keys: array of Cardinal; Buffer: Pointer; Capacity: Cardinal): Cardinal;
    function Fetch<T>(Get: Pointer; const Keys: array of Cardinal): TArray<T>;
    procedure FetchInfo(Get: Pointer; const Keys: array of Cardinal; Info: Pointer; Size: Cardinal);
  protected
    procedure DestroyHandle; virtual; abstract;
  public
    // Owns a handle that a function of toothseg_api made. Parent: any object of its context.
    constructor Wrap(Parent: TTsObject; AHandle: Pointer);
    destructor Destroy; override;
    // Gives back what the object holds; using it from then on raises ETsClosed.
    procedure Close;
    property Closed: Boolean read GetClosed;
    property Handle: Pointer read FHandle; // for the functions of toothseg_api
  end;

  // Threads, log and memory for all objects made from it.
  TTsContext = class(TTsObject)
  protected
    procedure DestroyHandle; override;
  public
    // Threads: 0 is one a core. What the events belong to has to live as long as any object made from the context.
    constructor Create(Threads: Cardinal = 0; OnLog: TTsLogEvent = nil; const Allocator: ITsAllocator = nil);
  end;

  // Progress and cancellation of one long call at a time.
  TTsJob = class(TTsObject)
  private
    FOnProgress: TTsProgressEvent;
    FRaised: TObject;
    function Progressed(Fraction: Double; Stage: PAnsiChar): Integer;
    function TakeRaised: TObject;
    function GetProgress: Double;
  protected
    procedure DestroyHandle; override;
  public
    constructor Create(Context: TTsContext; OnProgress: TTsProgressEvent = nil);
    destructor Destroy; override;
    // The call under way raises ETsCancelled soon. From any thread; stays until Reset.
    procedure Cancel;
    procedure Reset;
    property Progress: Double read GetProgress; // 0 to 1
  end;

  // A mesh after intake: welded, clean, manifold. Never changes.
  TTsModel = class(TTsObject)
  protected
    procedure DestroyHandle; override;
  public
    // From arrays; TsMeshInput describes them.
    constructor Create(Context: TTsContext; const Input: TTsMeshInput; Job: TTsJob = nil); overload;
    constructor Create(Context: TTsContext; const Input: TTsMeshInput; const Options: TTsIntakeOptions;
      Job: TTsJob = nil); overload;
    // From a file: STL, PLY, OBJ or OFF.
    constructor Load(Context: TTsContext; const Path: string; Job: TTsJob = nil); overload;
    constructor Load(Context: TTsContext; const Path: string; const Options: TTsIntakeOptions;
      Job: TTsJob = nil); overload;
    // From a file that is in memory.
    constructor Read(Context: TTsContext; const Bytes: array of Byte; Format: TTsFileFormat = TS_FORMAT_AUTO;
      Job: TTsJob = nil); overload;
    constructor Read(Context: TTsContext; const Bytes: array of Byte; Format: TTsFileFormat;
      const Options: TTsIntakeOptions; Job: TTsJob = nil); overload;
    function Report: TTsIntakeReport;
    function Positions: TTsPoints;
    function Triangles: TTsTriangles;
    function FaceSources: TTsIndices; // for each face that of the caller's it came from
    function VertexMap: TTsIndices; // for each vertex of the caller's that of the model, or TS_NONE
    function Nearest(const Position: TTsPoint): TTsSurfacePoint;
    function Raycast(const Origin, Direction: TTsPoint): TTsSurfacePoint;
  end;

  // Feature points of the teeth in groups, one a tooth.
  TTsFeatures = class(TTsObject)
  private
    function GetOcclusal: TTsPoint;
    procedure SetOcclusal(const Direction: TTsPoint);
  protected
    procedure DestroyHandle; override;
  public
    constructor Create(Model: TTsModel); // empty, to be filled by hand
    constructor Detect(Model: TTsModel; Job: TTsJob = nil); overload;
    constructor Detect(Model: TTsModel; const Options: TTsFeatureOptions; Job: TTsJob = nil); overload;
    function Clone: TTsFeatures;
    function Info: TTsFeaturesInfo;
    function Arch: TTsPoints;
    function Points: TTsFeaturePoints;
    function Groups: TTsFeatureGroups;
    // The id of the new point. Group: TS_NONE makes a new one.
    function AddPoint(const Position: TTsPoint; Group: Cardinal = TS_NONE): Cardinal;
    procedure MovePoint(Point: Cardinal; const Position: TTsPoint);
    function SetGroup(Point: Cardinal; Group: Cardinal = TS_NONE): Cardinal; // the id of its group
    procedure RemovePoint(Point: Cardinal);
    procedure RemoveGroup(Group: Cardinal);
    property Occlusal: TTsPoint read GetOcclusal write SetOcclusal; // unit vector from the gums to the biting surface
  end;

  // A prepared scan and the teeth separated so far. Teeth have ids: Teeth lists them.
  TTsSegmentation = class(TTsObject)
  private
    FOnChange: TTsChangeEvent;
    FRaised: TObject;
    procedure SetOnChange(Event: TTsChangeEvent);
    procedure Told(Teeth: PCardinal; Count: Cardinal);
    procedure Changed(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob = nil);
    procedure TakeSession(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob; Made: Pointer; out Features: TTsFeatures);
    function GetClickCount: Cardinal;
    function GetLocked(Tooth: Cardinal): Boolean;
    procedure SetLocked(Tooth: Cardinal; Locked: Boolean);
    function GetHistoryLimit: UInt64;
    procedure SetHistoryLimit(Bytes: UInt64);
  protected
    procedure DestroyHandle; override;
  public
    constructor Create(Features: TTsFeatures; Job: TTsJob = nil); overload;
    constructor Create(Features: TTsFeatures; const Options: TTsSegmentOptions; Job: TTsJob = nil); overload;
    // A session gone through again on its model, to go on with. The features as they were are the caller's.
    constructor LoadSession(Model: TTsModel; const Path: string; out Features: TTsFeatures; Job: TTsJob = nil);
    constructor ReadSession(Model: TTsModel; const Text: UTF8String; out Features: TTsFeatures; Job: TTsJob = nil);
    destructor Destroy; override;

    function Click(const Position: TTsPoint; Job: TTsJob = nil): Cardinal; // the number of the click
    function Clicks(const Positions: array of TTsPoint; Job: TTsJob = nil): TTsStatuses; // a status a click
    function ProposeClicks: TTsPoints; // the fewest that cover what is not separated yet
    procedure SegmentAll(Job: TTsJob = nil);
    function ClickInfo(Click: Cardinal): TTsClickInfo;
    function Field(Click: Cardinal): TTsValues;
    function Histogram(Click: Cardinal): TTsIndices;
    function Contours(Click: Cardinal): TTsContourInfos;
    function Contour(Click, Index: Cardinal): TTsPolylines;
    property ClickCount: Cardinal read GetClickCount;

    function Teeth: TTsIndices;
    function Tooth(Id: Cardinal): TTsToothInfo;
    function ToothFaces(Tooth: Cardinal): TTsIndices;
    function ToothVertices(Tooth: Cardinal): TTsIndices;
    function ToothSeeds(Tooth: Cardinal): TTsIndices;
    function ToothFrame(Tooth: Cardinal): TTsToothFrame;
    function Cut(Tooth: Cardinal; Loop: Cardinal = 0): TTsCut;
    function Labels: TTsIndices; // one for each of the caller's faces; 0 is no tooth
    procedure ReadLabels(var Labels: TTsIndices); // the same into an array that is used again
    function Review: TTsReview; // teeth that want a look
    function Overlaps: TTsOverlaps;

    procedure IncludePoint(Tooth: Cardinal; const Position: TTsPoint; Job: TTsJob = nil); // this too
    procedure ExcludePoint(Tooth: Cardinal; const Position: TTsPoint; Job: TTsJob = nil); // not this
    procedure MovePoint(Tooth: Cardinal; const Place, Target: TTsPoint; Job: TTsJob = nil);
    function SplitTooth(Tooth: Cardinal; const Keep, Part: TTsPoint; Job: TTsJob = nil): Cardinal; // the new tooth
    procedure MergeTeeth(Tooth, Other: Cardinal; Job: TTsJob = nil); // Other is no tooth any more
    procedure RemoveTooth(Tooth: Cardinal);
    property Locked[Tooth: Cardinal]: Boolean read GetLocked write SetLocked;

    procedure DragCut(Tooth, Loop, Point: Cardinal; const Target: TTsPoint; Reach: Double = 0; Job: TTsJob = nil);
    procedure DrawCut(Tooth: Cardinal; const Stroke: array of TTsPoint; Job: TTsJob = nil);
    procedure OffsetCut(Tooth: Cardinal; Distance: Double; Job: TTsJob = nil); // outwards where positive
    procedure SmoothCut(Tooth: Cardinal; Strength: Double; Job: TTsJob = nil);
    procedure ResetCut(Tooth: Cardinal);
    function CutEdits(Tooth: Cardinal): TTsCutEdits;

    procedure AssignNumbers; overload; // FDI
    procedure AssignNumbers(const Options: TTsNumberOptions); overload;
    procedure SetNumber(Tooth, Fdi: Cardinal); // 0 forgets one that was set
    function Number(Tooth: Cardinal): TTsNumberInfo;
    function Jaw: TTsJawInfo;

    procedure Undo;
    procedure Redo;
    function History: TTsHistoryInfo;
    function Changes: TTsIndices; // teeth that the last step changed
    property HistoryLimit: UInt64 read GetHistoryLimit write SetHistoryLimit; // bytes
    property OnChange: TTsChangeEvent read FOnChange write SetOnChange;

    function WriteSession: UTF8String; // for ReadSession
    procedure SaveSession(const Path: string); // for LoadSession
    procedure Save(const Path: string; Format: TTsOutputFormat; Job: TTsJob = nil); overload; // the scan with its teeth
    procedure Save(const Path: string; Format: TTsOutputFormat; const Options: TTsSaveOptions;
      Job: TTsJob = nil); overload;
    function Memory: TTsMemoryInfo;
    function PrepareTimes: TTsPrepareTimes;
  end;

  // A tooth, or the gingiva, as a mesh of its own, cut along the cuts. Never changes.
  TTsMesh = class(TTsObject)
  protected
    procedure DestroyHandle; override;
  public
    constructor OfTooth(Segmentation: TTsSegmentation; Tooth: Cardinal; Job: TTsJob = nil); overload;
    constructor OfTooth(Segmentation: TTsSegmentation; Tooth: Cardinal; const Options: TTsToothMeshOptions;
      Job: TTsJob = nil); overload;
    constructor OfGingiva(Segmentation: TTsSegmentation; Job: TTsJob = nil); overload;
    constructor OfGingiva(Segmentation: TTsSegmentation; const Options: TTsToothMeshOptions; Job: TTsJob = nil); overload;
    function Info: TTsMeshInfo;
    function Positions: TTsPoints;
    function Normals: TTsPoints;
    function Triangles: TTsTriangles;
    function Faces: TTsIndices; // for each triangle the model's face, or TS_NONE
    function VertexFlags: TTsFlags; // sums of TS_VERTEX_...
    procedure Save(const Path: string; Format: TTsOutputFormat; Job: TTsJob = nil);
  end;

  // Frees what was added, the last first, when the last reference to it goes: at the end of the routine that has it as a
  // local variable, also through an exception.
  ITsKeeper = interface
    ['{5F0B6E0E-5C7E-43C9-9D4B-7A5C0F0F4B0A}']
    procedure Add(Item: TObject);
  end;

function TsKeeper: ITsKeeper;

// ------------------------------------------------------------------------------------------------ options, small things

// Options with their defaults, to be changed where wanted.
function TsIntakeOptions: TTsIntakeOptions;
function TsFeatureOptions: TTsFeatureOptions;
function TsSegmentOptions(Preset: TTsPreset = TS_PRESET_DEFAULT): TTsSegmentOptions;
function TsNumberOptions: TTsNumberOptions;
function TsToothMeshOptions: TTsToothMeshOptions;
function TsSaveOptions: TTsSaveOptions;

// Describes arrays of the caller's, which have to live until a model is made of them. No triangles: a soup, three
// positions a face. Numbers are x, y, z of each vertex and three indices a face, one after the other.
function TsMeshInput(const Positions: array of TTsPoint; const Triangles: array of TTsTriangle): TTsMeshInput; overload;
function TsMeshInput(const Positions: array of Double; const Triangles: array of Cardinal): TTsMeshInput; overload;
function TsMeshInput(const Positions: array of Single; const Triangles: array of Cardinal): TTsMeshInput; overload;

function TsPoint(X, Y, Z: Double): TTsPoint;
function TsVersion: string; // of the library
function TsStatusName(Status: TTsStatus): string;
function TsFdiToUniversal(Fdi: Cardinal): Cardinal;
function TsUniversalToFdi(Universal: Cardinal): Cardinal;
function TsFdiToPalmer(Fdi: Cardinal): TTsPalmer;
// Raises what stands for a status that is not TS_OK. Text: the message; '' takes the status's name.
procedure TsCheck(Status: TTsStatus; const Text: string = '');

implementation

type
  THooks = class(TInterfacedObject, ITsHooks)
  private
    FHost: TTsFpu; // what callbacks run with: that of the thread that made the context
    FOnLog: TTsLogEvent;
    FAllocator: ITsAllocator;
    FRaised: Pointer;
    procedure Log(Level: TTsLogLevel; Text: PAnsiChar);
    function Allocate(Bytes: NativeUInt): Pointer;
    procedure Release(Memory: Pointer);
  public
    destructor Destroy; override;
    function TakeRaised: TObject;
  end;

  TKeeper = class(TInterfacedObject, ITsKeeper)
  private
    FItems: TArray<TObject>;
  public
    destructor Destroy; override;
    procedure Add(Item: TObject);
  end;

// ---------------------------------------------------------------------------------------------------------------- text

// The library's texts are UTF-8. Delphi's are UTF-16; Free Pascal's have the code page that they say.
function FromUtf8(Text: PAnsiChar): string;
{$IFDEF UNICODE}
begin
  Result := UTF8ToString(Text);
end;
{$ELSE}
var
  Raw: RawByteString;
begin
  SetString(Raw, Text, StrLen(Text));
  SetCodePage(Raw, CP_UTF8, False);
  Result := Raw;
end;
{$ENDIF}

function ToUtf8(const Text: string): UTF8String;
{$IFDEF UNICODE}
begin
  Result := UTF8Encode(Text);
end;
{$ELSE}
var
  Raw: RawByteString;
begin
  Raw := Text;
  // Names of files on Unix are bytes: those of an unconverted string are left as they are.
  {$IFDEF UNIX}
  if StringCodePage(Raw) <= 1 then
    SetCodePage(Raw, CP_UTF8, False);
  {$ENDIF}
  SetCodePage(Raw, CP_UTF8, True);
  Result := Raw;
end;
{$ENDIF}

// -------------------------------------------------------------------------------------------------------------- errors

constructor ETsError.Create(Status: TTsStatus; const Text: string);
begin
  inherited Create(Text);
  FStatus := Status;
end;

function ETsError.GetStatusName: string;
begin
  Result := TsStatusName(FStatus);
end;

type
  TErrorClass = class of ETsError;

function ClassOf(Status: TTsStatus): TErrorClass;
begin
  case Status of
    100 .. 199: Result := ETsUsage;
    TS_E_OUT_OF_MEMORY: Result := ETsOutOfMemory;
    TS_E_CANCELLED: Result := ETsCancelled;
    202 .. 299: Result := ETsSystem;
    300 .. 399: Result := ETsFile;
    400 .. 499: Result := ETsIntake;
    500 .. 599: Result := ETsFeatures;
    600 .. 649: Result := ETsSegmentation;
    650 .. 699: Result := ETsEdit;
    700 .. 749: Result := ETsNumber;
    750 .. 799: Result := ETsToothMesh;
  else
    Result := ETsError;
  end;
end;

procedure TsCheck(Status: TTsStatus; const Text: string);
begin
  if Status = TS_OK then
    Exit;
  if Text <> '' then
    raise ClassOf(Status).Create(Status, Text)
  else
    raise ClassOf(Status).Create(Status, TsStatusName(Status));
end;

// Before and after a call that has no object.
procedure Start(out Fpu: TTsFpu);
begin
  {$IFDEF TOOTHSEG_DYNAMIC}
  ts_need;
  {$ENDIF}
  TsMaskFpu(Fpu);
end;

procedure Finish(const Fpu: TTsFpu; Status: TTsStatus);
var
  Text: PAnsiChar;
begin
  Text := nil;
  if Status <> TS_OK then
    Text := ts_last_error_message();
  TsLoadFpu(Fpu);
  if Status <> TS_OK then
    TsCheck(Status, FromUtf8(Text));
end;

function Count32(Count: NativeInt): Cardinal;
begin
  if Int64(Count) > High(Cardinal) then
    TsCheck(TS_E_INVALID_ARGUMENT, 'more than 2^32 - 1 elements');
  Result := Cardinal(Count);
end;

// --------------------------------------------------------------------------------------------------------------- hooks

// Puts New where Expected is; gives what was there.
function Exchange(var Place: Pointer; New, Expected: Pointer): Pointer;
begin
  {$IFDEF FPC}
  Result := InterlockedCompareExchange(Place, New, Expected);
  {$ELSE}
  Result := AtomicCmpExchange(Place, New, Expected);
  {$ENDIF}
end;

destructor THooks.Destroy;
begin
  TakeRaised.Free;
  inherited;
end;

procedure THooks.Log(Level: TTsLogLevel; Text: PAnsiChar);
var
  Raised: TObject;
begin
  try
    FOnLog(Level, FromUtf8(Text));
  except
    Raised := TObject(AcquireExceptionObject);
    if Exchange(FRaised, Raised, nil) <> nil then
      Raised.Free; // the first one is told
  end;
end;

function THooks.Allocate(Bytes: NativeUInt): Pointer;
begin
  try
    Result := FAllocator.Allocate(Bytes);
  except
    Result := nil;
  end;
end;

procedure THooks.Release(Memory: Pointer);
begin
  try
    FAllocator.Release(Memory);
  except
    // Nobody can be told of it: the library goes on as if the memory were back.
  end;
end;

function THooks.TakeRaised: TObject;
begin
  Result := FRaised;
  if (Result <> nil) and (Exchange(FRaised, nil, Result) <> Pointer(Result)) then
    Result := nil; // another call has it
end;

// The functions that the library calls. In each the first thing is to note the floating-point control, before anything
// that touches a threadvar: on a thread that is not of Pascal's making that sets it. So no variables that need
// finalization, and no stack checks.
{$IFDEF FPC}
{$PUSH}
{$S-}
{$ENDIF}

procedure CallLog(Level: ts_log_level; Text: PAnsiChar; User: Pointer); cdecl;
var
  Fpu: TTsFpu;
begin
  TsReadFpu(Fpu);
  TsLoadFpu(THooks(User).FHost);
  THooks(User).Log(Level, Text);
  TsLoadFpu(Fpu);
end;

function CallAllocate(Bytes: NativeUInt; User: Pointer): Pointer; cdecl;
var
  Fpu: TTsFpu;
begin
  TsReadFpu(Fpu);
  TsLoadFpu(THooks(User).FHost);
  Result := THooks(User).Allocate(Bytes);
  TsLoadFpu(Fpu);
end;

procedure CallRelease(Memory: Pointer; User: Pointer); cdecl;
var
  Fpu: TTsFpu;
begin
  TsReadFpu(Fpu);
  TsLoadFpu(THooks(User).FHost);
  THooks(User).Release(Memory);
  TsLoadFpu(Fpu);
end;

function CallProgress(Fraction: Double; Stage: PAnsiChar; User: Pointer): Integer; cdecl;
var
  Fpu: TTsFpu;
begin
  TsReadFpu(Fpu);
  TsLoadFpu(TTsJob(User).FHost);
  Result := TTsJob(User).Progressed(Fraction, Stage);
  TsLoadFpu(Fpu);
end;

procedure CallChange(User: Pointer; Teeth: PCardinal; Count: Cardinal); cdecl;
var
  Fpu: TTsFpu;
begin
  TsReadFpu(Fpu);
  TsLoadFpu(TTsSegmentation(User).FHost);
  TTsSegmentation(User).Told(Teeth, Count);
  TsLoadFpu(Fpu);
end;
{$IFDEF FPC}
{$POP}
{$ENDIF}

{$IFDEF FPC}
function Nothing(Parameter: Pointer): PtrInt;
begin
  Result := 0;
end;

// Free Pascal locks its heap, and gives threads variables of their own, from the first thread on that it makes itself. The
// library's threads need both before they call back. Raises ENoThreadSupport where the program does not use cthreads.
procedure PrepareThreads;
var
  Thread, Id: TThreadID; // on Windows its handle and its number, elsewhere the same
  {$IFDEF UNIX}
  Manager: TThreadManager;
  {$ENDIF}
begin
  if IsMultiThread then
    Exit;
  {$IFDEF UNIX}
  GetThreadManager(Manager);
  if not Assigned(Manager.InitManager) then
    raise ENoThreadSupport.Create('callbacks need threads: cthreads has to be the first unit that the program uses');
  {$ENDIF}
  Thread := BeginThread(Nothing, nil, Id);
  if Thread <> TThreadID(0) then
    WaitForThreadTerminate(Thread, 0);
end;
{$ELSE}
procedure PrepareThreads;
begin
  IsMultiThread := True;
end;
{$ENDIF}

// ------------------------------------------------------------------------------------------------------------- objects

procedure NeedAlive(Item: TTsObject; const Name: string);
begin
  if Item = nil then
    raise ETsClosed.Create(TS_E_NULL, Name + ' is nil');
  if Item.FHandle = nil then
    raise ETsClosed.Create(TS_E_NULL, Item.ClassName + ' is closed');
end;

function HandleOf(Job: TTsJob): Pts_job;
begin
  Result := nil;
  if Job <> nil then
    Result := Job.FHandle;
end;

constructor TTsObject.Wrap(Parent: TTsObject; AHandle: Pointer);
begin
  inherited Create;
  NeedAlive(Parent, 'the object to make it from');
  FHandle := AHandle;
  FHooks := Parent.FHooks;
  FHost := Parent.FHost;
end;

destructor TTsObject.Destroy;
begin
  Close;
  inherited;
end;

procedure TTsObject.Close;
var
  Fpu: TTsFpu;
begin
  if FHandle = nil then
    Exit;
  TsMaskFpu(Fpu);
  DestroyHandle;
  FHandle := nil;
  TsLoadFpu(Fpu);
end;

function TTsObject.GetClosed: Boolean;
begin
  Result := FHandle = nil;
end;

// Everything that can be wrong is looked at before exceptions are masked; from then to Leave no Pascal code runs.
function TTsObject.Enter(Job: TTsJob): TTsFpu;
begin
  NeedAlive(Self, 'the object');
  if Job <> nil then
    NeedAlive(Job, 'the job');
  TsMaskFpu(Result);
end;

procedure TTsObject.Leave(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob);
var
  Text: PAnsiChar;
  OfJob, OfLog: TObject;
begin
  Text := nil;
  if Status <> TS_OK then
    Text := ts_last_error_message();
  TsLoadFpu(Fpu);
  OfLog := FHooks.TakeRaised;
  OfJob := nil;
  if Job <> nil then
    OfJob := Job.TakeRaised;
  if (OfJob <> nil) or (Status <> TS_OK) then
    FreeAndNil(OfLog);
  if OfJob <> nil then
    raise OfJob;
  if Status <> TS_OK then
    TsCheck(Status, FromUtf8(Text));
  if OfLog <> nil then
    raise OfLog;
end;

// A getter of the two-call idiom, or one of a single struct (Capacity 0, no Count): handle, keys, and what is filled.
function Invoke(Get: Pointer; Handle: Pointer; const Keys: array of Cardinal; Buffer: Pointer; Capacity: Cardinal;
  Count: PCardinal): TTsStatus;
type
  TGet0 = function(Handle, Buffer: Pointer; Capacity: Cardinal; Count: PCardinal): TTsStatus; cdecl;
  TGet1 = function(Handle: Pointer; A: Cardinal; Buffer: Pointer; Capacity: Cardinal; Count: PCardinal): TTsStatus; cdecl;
begin
  case Length(Keys) of
    0: Result := TGet0(Get)(Handle, Buffer, Capacity, Count);
  else
    Result := TGet1(Get)(Handle, Keys[0], Buffer, Capacity, Count);
  end;
end;

function TTsObject.Call(Get: Pointer; const Keys: array of Cardinal; Buffer: Pointer; Capacity: Cardinal): Cardinal;
var
  Fpu: TTsFpu;
begin
  Result := 0;
  Fpu := Enter;
  Leave(Fpu, Invoke(Get, FHandle, Keys, Buffer, Capacity, @Result));
end;

function TTsObject.Fetch<T>(Get: Pointer; const Keys: array of Cardinal): TArray<T>;
var
  Count: Cardinal;
begin
  Result := nil;
  Count := Call(Get, Keys, nil, 0);
  SetLength(Result, Count);
  if Count > 0 then
    Call(Get, Keys, Pointer(Result), Count);
end;

procedure TTsObject.FetchInfo(Get: Pointer; const Keys: array of Cardinal; Info: Pointer; Size: Cardinal);
type
  TGet0 = function(Handle, Info: Pointer): TTsStatus; cdecl;
  TGet1 = function(Handle: Pointer; Key: Cardinal; Info: Pointer): TTsStatus; cdecl;
var
  Fpu: TTsFpu;
  Status: TTsStatus;
begin
  FillChar(Info^, Size, 0);
  PCardinal(Info)^ := Size;
  Fpu := Enter;
  if Length(Keys) = 0 then
    Status := TGet0(Get)(FHandle, Info)
  else
    Status := TGet1(Get)(FHandle, Keys[0], Info);
  Leave(Fpu, Status);
end;

// ----------------------------------------------------------------------------------------------------- context and job

constructor TTsContext.Create(Threads: Cardinal; OnLog: TTsLogEvent; const Allocator: ITsAllocator);
var
  Options: ts_context_options;
  Hooks: THooks;
  Fpu: TTsFpu;
  Status: TTsStatus;
begin
  inherited Create;
  if Assigned(OnLog) or (Allocator <> nil) then
    PrepareThreads;
  Hooks := THooks.Create;
  FHooks := Hooks;
  TsReadFpu(Hooks.FHost);
  FHost := Hooks.FHost;
  Hooks.FOnLog := OnLog;
  Hooks.FAllocator := Allocator;
  Start(Fpu);
  Status := ts_context_options_init(@Options, SizeOf(Options));
  if Status = TS_OK then
  begin
    Options.Threads := Threads;
    if Assigned(OnLog) then
    begin
      Options.Log := CallLog;
      Options.LogUser := Hooks;
    end;
    if Allocator <> nil then
    begin
      Options.Alloc := CallAllocate;
      Options.Free := CallRelease;
      Options.AllocUser := Hooks;
    end;
    Status := ts_context_create(@Options, @FHandle);
  end;
  Leave(Fpu, Status);
end;

procedure TTsContext.DestroyHandle;
begin
  ts_context_destroy(FHandle);
end;

constructor TTsJob.Create(Context: TTsContext; OnProgress: TTsProgressEvent);
var
  Fpu: TTsFpu;
  Call: ts_progress_fn;
begin
  inherited Wrap(Context, nil);
  FOnProgress := OnProgress;
  Call := nil;
  if Assigned(OnProgress) then
  begin
    PrepareThreads;
    Call := CallProgress;
  end;
  Fpu := Context.Enter;
  Leave(Fpu, ts_job_create(Context.FHandle, Call, Self, @FHandle));
end;

destructor TTsJob.Destroy;
begin
  inherited;
  FreeAndNil(FRaised);
end;

procedure TTsJob.DestroyHandle;
begin
  ts_job_destroy(FHandle);
end;

function TTsJob.Progressed(Fraction: Double; Stage: PAnsiChar): Integer;
begin
  Result := 1;
  if FRaised <> nil then
    Exit;
  try
    if FOnProgress(Fraction, FromUtf8(Stage)) then
      Result := 0;
  except
    FRaised := TObject(AcquireExceptionObject);
  end;
end;

function TTsJob.TakeRaised: TObject;
begin
  Result := FRaised;
  FRaised := nil;
end;

procedure TTsJob.Cancel;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  ts_job_cancel(FHandle);
  TsLoadFpu(Fpu);
end;

procedure TTsJob.Reset;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  ts_job_reset(FHandle);
  TsLoadFpu(Fpu);
end;

function TTsJob.GetProgress: Double;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Result := ts_job_progress(FHandle);
  TsLoadFpu(Fpu);
end;

// --------------------------------------------------------------------------------------------------------------- model

constructor TTsModel.Create(Context: TTsContext; const Input: TTsMeshInput; Job: TTsJob);
begin
  Create(Context, Input, TsIntakeOptions, Job);
end;

constructor TTsModel.Create(Context: TTsContext; const Input: TTsMeshInput; const Options: TTsIntakeOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Context, nil);
  Fpu := Context.Enter(Job);
  Leave(Fpu, ts_model_create(Context.FHandle, @Input, @Options, HandleOf(Job), @FHandle), Job);
end;

constructor TTsModel.Load(Context: TTsContext; const Path: string; Job: TTsJob);
begin
  Load(Context, Path, TsIntakeOptions, Job);
end;

constructor TTsModel.Load(Context: TTsContext; const Path: string; const Options: TTsIntakeOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
  Name: UTF8String;
begin
  inherited Wrap(Context, nil);
  Name := ToUtf8(Path);
  Fpu := Context.Enter(Job);
  Leave(Fpu, ts_model_load(Context.FHandle, PAnsiChar(Name), @Options, HandleOf(Job), @FHandle), Job);
end;

constructor TTsModel.Read(Context: TTsContext; const Bytes: array of Byte; Format: TTsFileFormat; Job: TTsJob);
begin
  Read(Context, Bytes, Format, TsIntakeOptions, Job);
end;

constructor TTsModel.Read(Context: TTsContext; const Bytes: array of Byte; Format: TTsFileFormat;
  const Options: TTsIntakeOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Context, nil);
  Fpu := Context.Enter(Job);
  Leave(Fpu, ts_model_read(Context.FHandle, @Bytes, Length(Bytes), Format, @Options, HandleOf(Job), @FHandle), Job);
end;

procedure TTsModel.DestroyHandle;
begin
  ts_model_destroy(FHandle);
end;

function TTsModel.Report: TTsIntakeReport;
begin
  FetchInfo(@ts_model_get_report, [], @Result, SizeOf(Result));
end;

function TTsModel.Positions: TTsPoints;
begin
  Result := Fetch<TTsPoint>(@ts_model_get_positions, []);
end;

function TTsModel.Triangles: TTsTriangles;
begin
  Result := Fetch<TTsTriangle>(@ts_model_get_triangles, []);
end;

function TTsModel.FaceSources: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_model_get_face_sources, []);
end;

function TTsModel.VertexMap: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_model_get_vertex_map, []);
end;

function TTsModel.Nearest(const Position: TTsPoint): TTsSurfacePoint;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_model_nearest(FHandle, @Position, @Result));
end;

function TTsModel.Raycast(const Origin, Direction: TTsPoint): TTsSurfacePoint;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_model_raycast(FHandle, @Origin, @Direction, @Result));
end;

// ------------------------------------------------------------------------------------------------------------ features

constructor TTsFeatures.Create(Model: TTsModel);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Model, nil);
  Fpu := Model.Enter;
  Leave(Fpu, ts_features_create(Model.FHandle, @FHandle));
end;

constructor TTsFeatures.Detect(Model: TTsModel; Job: TTsJob);
begin
  Detect(Model, TsFeatureOptions, Job);
end;

constructor TTsFeatures.Detect(Model: TTsModel; const Options: TTsFeatureOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Model, nil);
  Fpu := Model.Enter(Job);
  Leave(Fpu, ts_detect_features(Model.FHandle, @Options, HandleOf(Job), @FHandle), Job);
end;

procedure TTsFeatures.DestroyHandle;
begin
  ts_features_destroy(FHandle);
end;

function TTsFeatures.Clone: TTsFeatures;
var
  Fpu: TTsFpu;
  Made: Pts_features;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_clone(FHandle, @Made));
  Result := TTsFeatures.Wrap(Self, Made);
end;

function TTsFeatures.Info: TTsFeaturesInfo;
begin
  FetchInfo(@ts_features_get_info, [], @Result, SizeOf(Result));
end;

function TTsFeatures.Arch: TTsPoints;
begin
  Result := Fetch<TTsPoint>(@ts_features_get_arch, []);
end;

function TTsFeatures.Points: TTsFeaturePoints;
begin
  Result := Fetch<TTsFeaturePoint>(@ts_features_get_points, []);
end;

function TTsFeatures.Groups: TTsFeatureGroups;
begin
  Result := Fetch<TTsFeatureGroup>(@ts_features_get_groups, []);
end;

function TTsFeatures.AddPoint(const Position: TTsPoint; Group: Cardinal): Cardinal;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_add_point(FHandle, @Position, Group, @Result, nil));
end;

procedure TTsFeatures.MovePoint(Point: Cardinal; const Position: TTsPoint);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_move_point(FHandle, Point, @Position));
end;

function TTsFeatures.SetGroup(Point: Cardinal; Group: Cardinal): Cardinal;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_set_group(FHandle, Point, Group, @Result));
end;

procedure TTsFeatures.RemovePoint(Point: Cardinal);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_remove_point(FHandle, Point));
end;

procedure TTsFeatures.RemoveGroup(Group: Cardinal);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_remove_group(FHandle, Group));
end;

function TTsFeatures.GetOcclusal: TTsPoint;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_get_occlusal(FHandle, @Result));
end;

procedure TTsFeatures.SetOcclusal(const Direction: TTsPoint);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_features_set_occlusal(FHandle, @Direction));
end;

// -------------------------------------------------------------------------------------------------------- segmentation

constructor TTsSegmentation.Create(Features: TTsFeatures; Job: TTsJob);
begin
  Create(Features, TsSegmentOptions, Job);
end;

constructor TTsSegmentation.Create(Features: TTsFeatures; const Options: TTsSegmentOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Features, nil);
  Fpu := Features.Enter(Job);
  Leave(Fpu, ts_segmentation_create(Features.FHandle, @Options, HandleOf(Job), @FHandle), Job);
end;

// Owns the features that a session was read with until the call is known to be good.
procedure TTsSegmentation.TakeSession(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob; Made: Pointer;
  out Features: TTsFeatures);
begin
  Features := nil;
  TsLoadFpu(Fpu);
  if Made <> nil then
    Features := TTsFeatures.Wrap(Self, Made);
  try
    Leave(Fpu, Status, Job);
  except
    FreeAndNil(Features);
    raise;
  end;
end;

constructor TTsSegmentation.LoadSession(Model: TTsModel; const Path: string; out Features: TTsFeatures; Job: TTsJob);
var
  Fpu: TTsFpu;
  Name: UTF8String;
  Made: Pts_features;
  Status: TTsStatus;
begin
  Features := nil;
  inherited Wrap(Model, nil);
  Name := ToUtf8(Path);
  Made := nil;
  Fpu := Model.Enter(Job);
  Status := ts_session_load(Model.FHandle, PAnsiChar(Name), HandleOf(Job), @Made, @FHandle);
  TakeSession(Fpu, Status, Job, Made, Features);
end;

constructor TTsSegmentation.ReadSession(Model: TTsModel; const Text: UTF8String; out Features: TTsFeatures; Job: TTsJob);
var
  Fpu: TTsFpu;
  Made: Pts_features;
  Status: TTsStatus;
begin
  Features := nil;
  inherited Wrap(Model, nil);
  Made := nil;
  Fpu := Model.Enter(Job);
  Status := ts_session_read(Model.FHandle, PAnsiChar(Text), Length(Text), HandleOf(Job), @Made, @FHandle);
  TakeSession(Fpu, Status, Job, Made, Features);
end;

destructor TTsSegmentation.Destroy;
begin
  inherited;
  FreeAndNil(FRaised);
end;

procedure TTsSegmentation.DestroyHandle;
begin
  ts_segmentation_destroy(FHandle);
end;

procedure TTsSegmentation.Told(Teeth: PCardinal; Count: Cardinal);
var
  List: TTsIndices;
begin
  try
    SetLength(List, Count);
    if Count > 0 then
      Move(Teeth^, List[0], Count * SizeOf(Cardinal));
    FOnChange(List);
  except
    FreeAndNil(FRaised);
    FRaised := TObject(AcquireExceptionObject);
  end;
end;

// As Leave, and then what the change event raised: the change itself stands.
procedure TTsSegmentation.Changed(const Fpu: TTsFpu; Status: TTsStatus; Job: TTsJob);
var
  Raised: TObject;
begin
  Raised := FRaised;
  FRaised := nil;
  try
    Leave(Fpu, Status, Job);
  except
    Raised.Free;
    raise;
  end;
  if Raised <> nil then
    raise Raised;
end;

procedure TTsSegmentation.SetOnChange(Event: TTsChangeEvent);
var
  Fpu: TTsFpu;
  Call: ts_change_fn;
begin
  Call := nil;
  if Assigned(Event) then
    Call := CallChange;
  Fpu := Enter;
  Leave(Fpu, ts_set_change_callback(FHandle, Call, Self));
  FOnChange := Event;
end;

function TTsSegmentation.Click(const Position: TTsPoint; Job: TTsJob): Cardinal;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_segment_click(FHandle, @Position, HandleOf(Job), @Result), Job);
end;

function TTsSegmentation.Clicks(const Positions: array of TTsPoint; Job: TTsJob): TTsStatuses;
var
  Fpu: TTsFpu;
  Count: Cardinal;
begin
  Result := nil;
  Count := Count32(Length(Positions));
  SetLength(Result, Count);
  if Count = 0 then
    Exit;
  Fpu := Enter(Job);
  Changed(Fpu, ts_segment_clicks(FHandle, @Positions[0][0], Count, HandleOf(Job), @Result[0]), Job);
end;

function TTsSegmentation.ProposeClicks: TTsPoints;
begin
  Result := Fetch<TTsPoint>(@ts_propose_clicks, []);
end;

procedure TTsSegmentation.SegmentAll(Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_segment_all(FHandle, HandleOf(Job)), Job);
end;

function TTsSegmentation.GetClickCount: Cardinal;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_get_click_count(FHandle, @Result));
end;

function TTsSegmentation.ClickInfo(Click: Cardinal): TTsClickInfo;
begin
  FetchInfo(@ts_get_click, [Click], @Result, SizeOf(Result));
end;

function TTsSegmentation.Field(Click: Cardinal): TTsValues;
begin
  Result := Fetch<Double>(@ts_get_field, [Click]);
end;

function TTsSegmentation.Histogram(Click: Cardinal): TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_histogram, [Click]);
end;

function TTsSegmentation.Contours(Click: Cardinal): TTsContourInfos;
begin
  Result := Fetch<TTsContourInfo>(@ts_get_contours, [Click]);
end;

// The library gives all points of a contour in one array, and where each polyline begins in it.
function TTsSegmentation.Contour(Click, Index: Cardinal): TTsPolylines;
var
  Infos: TTsContourInfos;
  All: TTsEdgePoints;
  Starts: TTsIndices;
  Closed: TTsFlags;
  Count, I, Past: Cardinal;
  Fpu: TTsFpu;
begin
  Result := nil;
  Infos := Contours(Click);
  if Index >= Cardinal(Length(Infos)) then
    TsCheck(TS_E_NOT_FOUND, Format('no contour %d', [Index]));
  Count := Infos[Index].Polylines;
  SetLength(All, Infos[Index].Points);
  SetLength(Starts, Count);
  SetLength(Closed, Count);
  SetLength(Result, Count);
  if Count = 0 then
    Exit;
  Fpu := Enter;
  Leave(Fpu, ts_get_contour_points(FHandle, Click, Index, Pointer(All), Length(All), nil, Pointer(Starts),
    Pointer(Closed)));
  for I := 0 to Count - 1 do
  begin
    Past := Length(All);
    if I + 1 < Count then
      Past := Starts[I + 1];
    Result[I].Points := Copy(All, Starts[I], Past - Starts[I]);
    Result[I].Closed := Closed[I] <> 0;
  end;
end;

function TTsSegmentation.Teeth: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_teeth, []);
end;

function TTsSegmentation.Tooth(Id: Cardinal): TTsToothInfo;
begin
  FetchInfo(@ts_get_tooth, [Id], @Result, SizeOf(Result));
end;

function TTsSegmentation.ToothFaces(Tooth: Cardinal): TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_tooth_faces, [Tooth]);
end;

function TTsSegmentation.ToothVertices(Tooth: Cardinal): TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_tooth_vertices, [Tooth]);
end;

function TTsSegmentation.ToothSeeds(Tooth: Cardinal): TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_tooth_seeds, [Tooth]);
end;

function TTsSegmentation.ToothFrame(Tooth: Cardinal): TTsToothFrame;
begin
  FetchInfo(@ts_get_tooth_frame, [Tooth], @Result, SizeOf(Result));
end;

function TTsSegmentation.Cut(Tooth: Cardinal; Loop: Cardinal): TTsCut;
var
  Fpu: TTsFpu;
begin
  FillChar(Result.Info, SizeOf(Result.Info), 0);
  Result.Info.StructSize := SizeOf(Result.Info);
  Fpu := Enter;
  Leave(Fpu, ts_get_cut(FHandle, Tooth, Loop, @Result.Info, nil, 0, nil));
  SetLength(Result.Points, Result.Info.Points);
  Fpu := Enter;
  Leave(Fpu, ts_get_cut(FHandle, Tooth, Loop, nil, Pointer(Result.Points), Length(Result.Points), nil));
end;

function TTsSegmentation.Labels: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_labels, []);
end;

procedure TTsSegmentation.ReadLabels(var Labels: TTsIndices);
var
  Count: Cardinal;
begin
  Count := Call(@ts_get_labels, [], nil, 0);
  if Cardinal(Length(Labels)) <> Count then
    SetLength(Labels, Count);
  Call(@ts_get_labels, [], Pointer(Labels), Count);
end;

function TTsSegmentation.Review: TTsReview;
begin
  Result := Fetch<TTsReviewItem>(@ts_get_review, []);
end;

function TTsSegmentation.Overlaps: TTsOverlaps;
begin
  Result := Fetch<TTsOverlap>(@ts_get_overlaps, []);
end;

procedure TTsSegmentation.IncludePoint(Tooth: Cardinal; const Position: TTsPoint; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_tooth_include(FHandle, Tooth, @Position, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.ExcludePoint(Tooth: Cardinal; const Position: TTsPoint; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_tooth_exclude(FHandle, Tooth, @Position, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.MovePoint(Tooth: Cardinal; const Place, Target: TTsPoint; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_tooth_move_point(FHandle, Tooth, @Place, @Target, HandleOf(Job)), Job);
end;

function TTsSegmentation.SplitTooth(Tooth: Cardinal; const Keep, Part: TTsPoint; Job: TTsJob): Cardinal;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_tooth_split(FHandle, Tooth, @Keep, @Part, HandleOf(Job), @Result), Job);
end;

procedure TTsSegmentation.MergeTeeth(Tooth, Other: Cardinal; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_tooth_merge(FHandle, Tooth, Other, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.RemoveTooth(Tooth: Cardinal);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_tooth_remove(FHandle, Tooth));
end;

function TTsSegmentation.GetLocked(Tooth: Cardinal): Boolean;
var
  Fpu: TTsFpu;
  Value: Cardinal;
begin
  Fpu := Enter;
  Leave(Fpu, ts_tooth_get_locked(FHandle, Tooth, @Value));
  Result := Value <> 0;
end;

procedure TTsSegmentation.SetLocked(Tooth: Cardinal; Locked: Boolean);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_tooth_set_locked(FHandle, Tooth, Ord(Locked)));
end;

procedure TTsSegmentation.DragCut(Tooth, Loop, Point: Cardinal; const Target: TTsPoint; Reach: Double; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_cut_drag(FHandle, Tooth, Loop, Point, @Target, Reach, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.DrawCut(Tooth: Cardinal; const Stroke: array of TTsPoint; Job: TTsJob);
var
  Fpu: TTsFpu;
  Count: Cardinal;
begin
  Count := Count32(Length(Stroke));
  Fpu := Enter(Job);
  Changed(Fpu, ts_cut_draw(FHandle, Tooth, @Stroke, Count, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.OffsetCut(Tooth: Cardinal; Distance: Double; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_cut_offset(FHandle, Tooth, Distance, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.SmoothCut(Tooth: Cardinal; Strength: Double; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter(Job);
  Changed(Fpu, ts_cut_smooth(FHandle, Tooth, Strength, HandleOf(Job)), Job);
end;

procedure TTsSegmentation.ResetCut(Tooth: Cardinal);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_cut_reset(FHandle, Tooth));
end;

function TTsSegmentation.CutEdits(Tooth: Cardinal): TTsCutEdits;
begin
  Result := Fetch<TTsCutEdit>(@ts_get_cut_edits, [Tooth]);
end;

procedure TTsSegmentation.AssignNumbers;
begin
  AssignNumbers(TsNumberOptions);
end;

procedure TTsSegmentation.AssignNumbers(const Options: TTsNumberOptions);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_assign_numbers(FHandle, @Options));
end;

procedure TTsSegmentation.SetNumber(Tooth, Fdi: Cardinal);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_set_number(FHandle, Tooth, Fdi));
end;

function TTsSegmentation.Number(Tooth: Cardinal): TTsNumberInfo;
begin
  FetchInfo(@ts_get_number, [Tooth], @Result, SizeOf(Result));
end;

function TTsSegmentation.Jaw: TTsJawInfo;
begin
  FetchInfo(@ts_get_jaw, [], @Result, SizeOf(Result));
end;

procedure TTsSegmentation.Undo;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_undo(FHandle));
end;

procedure TTsSegmentation.Redo;
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Changed(Fpu, ts_redo(FHandle));
end;

function TTsSegmentation.History: TTsHistoryInfo;
begin
  FetchInfo(@ts_get_history, [], @Result, SizeOf(Result));
end;

function TTsSegmentation.Changes: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_get_changes, []);
end;

function TTsSegmentation.GetHistoryLimit: UInt64;
begin
  Result := History.Limit;
end;

procedure TTsSegmentation.SetHistoryLimit(Bytes: UInt64);
var
  Fpu: TTsFpu;
begin
  Fpu := Enter;
  Leave(Fpu, ts_set_history_limit(FHandle, Bytes));
end;

function TTsSegmentation.WriteSession: UTF8String;
var
  Count: Cardinal;
begin
  Count := Call(@ts_session_write, [], nil, 0);
  SetLength(Result, Count);
  Call(@ts_session_write, [], Pointer(Result), Count);
end;

procedure TTsSegmentation.SaveSession(const Path: string);
var
  Fpu: TTsFpu;
  Name: UTF8String;
begin
  Name := ToUtf8(Path);
  Fpu := Enter;
  Leave(Fpu, ts_session_save(FHandle, PAnsiChar(Name)));
end;

procedure TTsSegmentation.Save(const Path: string; Format: TTsOutputFormat; Job: TTsJob);
begin
  Save(Path, Format, TsSaveOptions, Job);
end;

procedure TTsSegmentation.Save(const Path: string; Format: TTsOutputFormat; const Options: TTsSaveOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
  Name: UTF8String;
begin
  Name := ToUtf8(Path);
  Fpu := Enter(Job);
  Leave(Fpu, ts_segmentation_save(FHandle, PAnsiChar(Name), Format, @Options, HandleOf(Job)), Job);
end;

function TTsSegmentation.Memory: TTsMemoryInfo;
begin
  FetchInfo(@ts_get_memory, [], @Result, SizeOf(Result));
end;

function TTsSegmentation.PrepareTimes: TTsPrepareTimes;
begin
  FetchInfo(@ts_get_prepare_times, [], @Result, SizeOf(Result));
end;

// ---------------------------------------------------------------------------------------------------------------- mesh

constructor TTsMesh.OfTooth(Segmentation: TTsSegmentation; Tooth: Cardinal; Job: TTsJob);
begin
  OfTooth(Segmentation, Tooth, TsToothMeshOptions, Job);
end;

constructor TTsMesh.OfTooth(Segmentation: TTsSegmentation; Tooth: Cardinal; const Options: TTsToothMeshOptions;
  Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Segmentation, nil);
  Fpu := Segmentation.Enter(Job);
  Leave(Fpu, ts_tooth_mesh_create(Segmentation.FHandle, Tooth, @Options, HandleOf(Job), @FHandle), Job);
end;

constructor TTsMesh.OfGingiva(Segmentation: TTsSegmentation; Job: TTsJob);
begin
  OfGingiva(Segmentation, TsToothMeshOptions, Job);
end;

constructor TTsMesh.OfGingiva(Segmentation: TTsSegmentation; const Options: TTsToothMeshOptions; Job: TTsJob);
var
  Fpu: TTsFpu;
begin
  inherited Wrap(Segmentation, nil);
  Fpu := Segmentation.Enter(Job);
  Leave(Fpu, ts_gingiva_mesh_create(Segmentation.FHandle, @Options, HandleOf(Job), @FHandle), Job);
end;

procedure TTsMesh.DestroyHandle;
begin
  ts_mesh_destroy(FHandle);
end;

function TTsMesh.Info: TTsMeshInfo;
begin
  FetchInfo(@ts_mesh_get_info, [], @Result, SizeOf(Result));
end;

function TTsMesh.Positions: TTsPoints;
begin
  Result := Fetch<TTsPoint>(@ts_mesh_get_positions, []);
end;

function TTsMesh.Normals: TTsPoints;
begin
  Result := Fetch<TTsPoint>(@ts_mesh_get_normals, []);
end;

function TTsMesh.Triangles: TTsTriangles;
begin
  Result := Fetch<TTsTriangle>(@ts_mesh_get_triangles, []);
end;

function TTsMesh.Faces: TTsIndices;
begin
  Result := Fetch<Cardinal>(@ts_mesh_get_faces, []);
end;

function TTsMesh.VertexFlags: TTsFlags;
begin
  Result := Fetch<Byte>(@ts_mesh_get_vertex_flags, []);
end;

procedure TTsMesh.Save(const Path: string; Format: TTsOutputFormat; Job: TTsJob);
var
  Fpu: TTsFpu;
  Name: UTF8String;
begin
  Name := ToUtf8(Path);
  Fpu := Enter(Job);
  Leave(Fpu, ts_mesh_save(FHandle, PAnsiChar(Name), Format, HandleOf(Job)), Job);
end;

// -------------------------------------------------------------------------------------------------------------- keeper

destructor TKeeper.Destroy;
var
  I: Integer;
begin
  for I := High(FItems) downto 0 do
    FItems[I].Free;
  inherited;
end;

procedure TKeeper.Add(Item: TObject);
begin
  SetLength(FItems, Length(FItems) + 1);
  FItems[High(FItems)] := Item;
end;

function TsKeeper: ITsKeeper;
begin
  Result := TKeeper.Create;
end;

// ------------------------------------------------------------------------------------------------------- small things

function TsIntakeOptions: TTsIntakeOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_intake_options_init(@Result, SizeOf(Result)));
end;

function TsFeatureOptions: TTsFeatureOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_feature_options_init(@Result, SizeOf(Result)));
end;

function TsSegmentOptions(Preset: TTsPreset): TTsSegmentOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_segment_options_init(@Result, SizeOf(Result), Preset));
end;

function TsNumberOptions: TTsNumberOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_number_options_init(@Result, SizeOf(Result)));
end;

function TsToothMeshOptions: TTsToothMeshOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_tooth_mesh_options_init(@Result, SizeOf(Result)));
end;

function TsSaveOptions: TTsSaveOptions;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_save_options_init(@Result, SizeOf(Result)));
end;

function MeshInput(Scalar: ts_scalar; Positions: Pointer; PositionCount: NativeInt; Triangles: Pointer;
  TriangleCount: NativeInt): TTsMeshInput;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_mesh_input_init(@Result, SizeOf(Result)));
  Result.Scalar := Scalar;
  Result.Positions := Positions;
  Result.VertexCount := Count32(PositionCount);
  if TriangleCount > 0 then
    Result.Triangles := Triangles;
  Result.TriangleCount := Count32(TriangleCount);
end;

// Numbers in threes.
function Threes(Count: NativeInt; const What: string): NativeInt;
begin
  if Count mod 3 <> 0 then
    TsCheck(TS_E_INVALID_ARGUMENT, Format('%s: %d numbers, which is no multiple of 3', [What, Count]));
  Result := Count div 3;
end;

function TsMeshInput(const Positions: array of TTsPoint; const Triangles: array of TTsTriangle): TTsMeshInput;
begin
  Result := MeshInput(TS_FLOAT64, @Positions, Length(Positions), @Triangles, Length(Triangles));
end;

function TsMeshInput(const Positions: array of Double; const Triangles: array of Cardinal): TTsMeshInput;
begin
  Result := MeshInput(TS_FLOAT64, @Positions, Threes(Length(Positions), 'positions'), @Triangles,
    Threes(Length(Triangles), 'triangles'));
end;

function TsMeshInput(const Positions: array of Single; const Triangles: array of Cardinal): TTsMeshInput;
begin
  Result := MeshInput(TS_FLOAT32, @Positions, Threes(Length(Positions), 'positions'), @Triangles,
    Threes(Length(Triangles), 'triangles'));
end;

function TsPoint(X, Y, Z: Double): TTsPoint;
begin
  Result[0] := X;
  Result[1] := Y;
  Result[2] := Z;
end;

function TsVersion: string;
var
  Fpu: TTsFpu;
  Text: PAnsiChar;
begin
  Start(Fpu);
  Text := ts_version();
  TsLoadFpu(Fpu);
  Result := FromUtf8(Text);
end;

function TsStatusName(Status: TTsStatus): string;
var
  Fpu: TTsFpu;
  Text: PAnsiChar;
begin
  Start(Fpu);
  Text := ts_status_name(Status);
  TsLoadFpu(Fpu);
  Result := FromUtf8(Text);
end;

function TsFdiToUniversal(Fdi: Cardinal): Cardinal;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_fdi_to_universal(Fdi, @Result));
end;

function TsUniversalToFdi(Universal: Cardinal): Cardinal;
var
  Fpu: TTsFpu;
begin
  Start(Fpu);
  Finish(Fpu, ts_universal_to_fdi(Universal, @Result));
end;

function TsFdiToPalmer(Fdi: Cardinal): TTsPalmer;
var
  Fpu: TTsFpu;
begin
  FillChar(Result, SizeOf(Result), 0);
  Result.StructSize := SizeOf(Result);
  Start(Fpu);
  Finish(Fpu, ts_fdi_to_palmer(Fdi, @Result));
end;

end.
