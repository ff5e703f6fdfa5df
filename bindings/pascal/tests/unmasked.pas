// The library as C has it, on a scan: unmasked SCAN [masked]. Without floating-point exceptions masked it does not come to
// an end: this is what toothseg.pas is there to prevent. SPDX-License-Identifier: Apache-2.0
program unmasked;

{$MODE DELPHI}

uses
  {$IFDEF UNIX}cthreads,{$ENDIF} SysUtils, toothseg_api, toothseg_fpu;

var
  Fpu: TTsFpu;
  Context: Pts_context;
  Model: Pts_model;
  Features: Pts_features;

procedure Try_(Status: ts_status);
begin
  if Status <> TS_OK then
    Halt(2);
end;

begin
  if ParamStr(2) = 'masked' then
    TsMaskFpu(Fpu);
  Try_(ts_context_create(nil, @Context));
  Try_(ts_model_load(Context, PAnsiChar(ParamStr(1)), nil, nil, @Model));
  Try_(ts_detect_features(Model, nil, nil, @Features));
  ts_features_destroy(Features);
  ts_model_destroy(Model);
  ts_context_destroy(Context);
end.
