// The shortest way to a tooth: hello_tooth SCAN [X Y Z] prints the cut around the tooth at X Y Z (mm, on the surface), or
// around the first one that the library proposes. SPDX-License-Identifier: Apache-2.0
program hello_tooth;

{$IFDEF FPC}{$MODE DELPHI}{$ENDIF}
{$IFNDEF FPC}{$APPTYPE CONSOLE}{$ENDIF}

uses
  SysUtils, toothseg;

var
  Form: TFormatSettings; // a decimal point in every country

procedure Run;
var
  Context: TTsContext;
  Model: TTsModel;
  Features: TTsFeatures;
  Segmentation: TTsSegmentation;
  Place: TTsPoint;
  Click: TTsClickInfo;
  Point: TTsEdgePoint;
begin
  Model := nil;
  Features := nil;
  Segmentation := nil;
  Context := TTsContext.Create;
  try
    Model := TTsModel.Load(Context, ParamStr(1));
    Features := TTsFeatures.Detect(Model);
    Segmentation := TTsSegmentation.Create(Features);
    if ParamCount = 4 then
      Place := TsPoint(StrToFloat(ParamStr(2), Form), StrToFloat(ParamStr(3), Form),
        StrToFloat(ParamStr(4), Form))
    else
      Place := Segmentation.ProposeClicks[0];
    Click := Segmentation.ClickInfo(Segmentation.Click(Place));
    for Point in Segmentation.Cut(Click.Target).Points do
      WriteLn(Format('%.4f %.4f %.4f', [Point.Position[0], Point.Position[1], Point.Position[2]], Form));
  finally
    Segmentation.Free;
    Features.Free;
    Model.Free;
    Context.Free;
  end;
end;

begin
  if (ParamCount <> 1) and (ParamCount <> 4) then
  begin
    WriteLn(ErrOutput, 'usage: hello_tooth SCAN [X Y Z]');
    Halt(2);
  end;
  Form.DecimalSeparator := '.';
  try
    Run;
  except
    on E: Exception do
    begin
      WriteLn(ErrOutput, 'hello_tooth: ', E.Message);
      Halt(1);
    end;
  end;
end.
