// What the layer costs: overhead SCAN prints JSON. SPDX-License-Identifier: Apache-2.0
//
//   call_ns          TsFdiToUniversal, which does next to nothing
//   call_masked_ns   the same where the program has masked floating-point exceptions itself
//   call_c_ns        ts_fdi_to_universal
//   labels_ms        TTsSegmentation.Labels, median
//   labels_again_ms  ReadLabels into an array that is used again
//   labels_c_ms      ts_get_labels twice, for the number and into memory as malloc gives it, as a C program does it
program overhead;

{$IFDEF FPC}{$MODE DELPHI}{$ENDIF}
{$IFNDEF FPC}{$APPTYPE CONSOLE}{$ENDIF}

uses
{$IFDEF FPC}
  Unix, BaseUnix,
{$ELSE}
  Diagnostics,
{$ENDIF}
  SysUtils, toothseg, toothseg_api, toothseg_fpu;

const
  Calls = 1000000;
  Rounds = 50;

type
  TTimes = array [0 .. Rounds - 1] of Double;

// Microseconds from some beginning.
function Clock: Double;
{$IFDEF FPC}
var
  Time: TTimeVal;
begin
  fpGetTimeOfDay(@Time, nil);
  Result := Int64(Time.tv_sec) * 1000000 + Time.tv_usec;
end;
{$ELSE}
begin
  Result := TStopwatch.GetTimeStamp / TStopwatch.Frequency * 1000000;
end;
{$ENDIF}

function Median(Times: TTimes): Double;
var
  I, K: Integer;
  Swap: Double;
begin
  for I := 1 to Rounds - 1 do
    for K := I downto 1 do
      if Times[K] < Times[K - 1] then
      begin
        Swap := Times[K];
        Times[K] := Times[K - 1];
        Times[K - 1] := Swap;
      end;
  Result := (Times[Rounds div 2 - 1] + Times[Rounds div 2]) / 2;
end;

function Call: Double;
var
  I: Integer;
  Begun: Double;
begin
  Begun := Clock;
  for I := 1 to Calls do
    TsFdiToUniversal(16);
  Result := (Clock - Begun) * 1000 / Calls;
end;

function CallC: Double;
var
  I: Integer;
  Begun: Double;
  Universal: Cardinal;
begin
  Begun := Clock;
  for I := 1 to Calls do
    ts_fdi_to_universal(16, @Universal);
  Result := (Clock - Begun) * 1000 / Calls;
end;

procedure Run;
var
  Keep: ITsKeeper;
  Context: TTsContext;
  Model: TTsModel;
  Features: TTsFeatures;
  Segmentation: TTsSegmentation;
  Labels, Again: TTsIndices;
  Memory: Pointer;
  Times, TimesAgain, TimesC: TTimes;
  Begun, Masked: Double;
  Fpu: TTsFpu;
  Count: Cardinal;
  I: Integer;
begin
  Keep := TsKeeper;
  Context := TTsContext.Create;
  Keep.Add(Context);
  Model := TTsModel.Load(Context, ParamStr(1));
  Keep.Add(Model);
  Features := TTsFeatures.Detect(Model);
  Keep.Add(Features);
  Segmentation := TTsSegmentation.Create(Features);
  Keep.Add(Segmentation);
  Segmentation.SegmentAll;
  Again := nil;
  for I := 0 to Rounds - 1 do
  begin
    Labels := nil;
    Begun := Clock;
    Labels := Segmentation.Labels;
    Times[I] := Clock - Begun;
    Begun := Clock;
    Segmentation.ReadLabels(Again);
    TimesAgain[I] := Clock - Begun;
    TsMaskFpu(Fpu);
    Begun := Clock;
    ts_get_labels(Segmentation.Handle, nil, 0, @Count);
    GetMem(Memory, Count * SizeOf(Cardinal));
    ts_get_labels(Segmentation.Handle, Memory, Count, @Count);
    TimesC[I] := Clock - Begun;
    FreeMem(Memory);
    TsLoadFpu(Fpu);
  end;
  TsMaskFpu(Fpu);
  Masked := Call;
  TsLoadFpu(Fpu);
  WriteLn('{"faces": ', Length(Labels), ', "call_ns": ', Call: 0: 1, ', "call_masked_ns": ', Masked: 0: 1,
    ', "call_c_ns": ', CallC: 0: 1, ', "labels_ms": ', Median(Times) / 1000: 0: 3, ', "labels_again_ms": ',
    Median(TimesAgain) / 1000: 0: 3, ', "labels_c_ms": ', Median(TimesC) / 1000: 0: 3, '}');
end;

begin
  if ParamCount <> 1 then
  begin
    WriteLn(ErrOutput, 'usage: overhead SCAN');
    Halt(2);
  end;
  Run;
end.
