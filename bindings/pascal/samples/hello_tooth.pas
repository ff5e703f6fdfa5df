// The shortest way to a tooth: hello_tooth SCAN [X Y Z] prints the cut around the tooth at X Y Z (mm, on the surface), or
// around the first one that the library proposes. SPDX-License-Identifier: Apache-2.0
program hello_tooth;

{$IFDEF FPC}{$MODE DELPHI}{$ENDIF}
{$APPTYPE CONSOLE}

uses
  SysUtils, toothseg;

// Point I of a polyline, with a decimal point in every country.
function Line(const Point: TTsPoint): string;
var
  Form: TFormatSettings;
begin
  FillChar(Form, SizeOf(Form), 0);
  Form.DecimalSeparator := '.';
  Result := Format('%.4f %.4f %.4f', [Point[0], Point[1], Point[2]], Form);
end;

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
      Place := TsPoint(StrToFloat(ParamStr(2)), StrToFloat(ParamStr(3)), StrToFloat(ParamStr(4)))
    else
      Place := Segmentation.ProposeClicks[0];
    Click := Segmentation.ClickInfo(Segmentation.Click(Place));
    for Point in Segmentation.Cut(Click.Target).Points do
      WriteLn(Line(Point.Position));
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
