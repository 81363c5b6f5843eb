using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>A comparison for other programs: one JSON object, every number by its name.</summary>
public static class ComparisonJson
{
    /// <summary>Writes it. Lines count from the top, rows from the bottom; an infinite PSNR is null.</summary>
    /// <param name="output">Takes UTF-8.</param>
    /// <param name="comparison">The comparison.</param>
    /// <param name="mine">What the picture in question is called.</param>
    /// <param name="reference">What the one that it should be is called.</param>
    public static void Write(Stream output, PictureComparison comparison, string mine, string reference)
    {
        using var json = new Utf8JsonWriter(output, JsonForm.Options);
        json.WriteStartObject();
        WritePicture(json, "mine", mine, comparison.Mine);
        WritePicture(json, "reference", reference, comparison.Reference);
        json.WriteString("verdict", ComparisonText.Of(comparison.Likeness));
        json.WriteBoolean("same", comparison.Likeness.IsSame());
        if (comparison.Difference is { } difference) WriteDifference(json, difference);
        if (comparison.Recognition is { } recognition) WriteRecognition(json, recognition);
        if (comparison.ByModels is { } models) WriteModels(json, comparison.Scene!, models);
        json.WriteEndObject();
        json.Flush();
        output.WriteByte((byte)'\n');
    }

    private static void WritePicture(Utf8JsonWriter json, string name, string file, Picture picture)
    {
        json.WriteStartObject(name);
        json.WriteString("file", file);
        json.WriteNumber("width", picture.Width);
        json.WriteNumber("height", picture.Height);
        json.WriteEndObject();
    }

    private static void WriteDifference(Utf8JsonWriter json, PictureDifference d)
    {
        json.WriteNumber("pixels", d.Pixels);
        json.WriteNumber("wrong", d.Wrong);
        json.WriteNumber("offByOne", d.OffByOne);
        json.WriteNumber("oneDarker", d.OneDarker);
        json.WriteStartObject("wrongByChannel");
        json.WriteNumber("red", d.WrongByChannel.R);
        json.WriteNumber("green", d.WrongByChannel.G);
        json.WriteNumber("blue", d.WrongByChannel.B);
        json.WriteEndObject();
        var last = d.Mine.Height - 1;
        if (d.WrongMiddle is var (x, y))
        {
            json.WriteStartObject("wrongMiddle");
            json.WriteNumber("column", x);
            json.WriteNumber("line", y);
            json.WriteNumber("row", last - y);
            WriteBytes(json, "mine", d.Mine[x, y]);
            WriteBytes(json, "reference", d.Reference[x, y]);
            json.WriteEndObject();
        }
        if (d.WrongArea is var (left, top, right, bottom))
        {
            json.WriteStartObject("wrongArea");
            json.WriteNumber("firstColumn", left);
            json.WriteNumber("lastColumn", right);
            json.WriteNumber("firstLine", top);
            json.WriteNumber("lastLine", bottom);
            json.WriteNumber("firstRow", last - bottom);
            json.WriteNumber("lastRow", last - top);
            json.WriteEndObject();
        }
        WriteMeasures(json, new(d));
    }

    private static void WriteMeasures(Utf8JsonWriter json, Measures m)
    {
        json.WriteStartObject("measures");
        json.WriteNumber("maximum", m.Maximum);
        json.WriteNumber("mae", m.MeanAbsoluteError);
        json.WriteNumber("rmse", m.RootMeanSquareError);
        if (double.IsFinite(m.PeakSignalToNoiseRatio)) json.WriteNumber("psnr", m.PeakSignalToNoiseRatio);
        else json.WriteNull("psnr");
        json.WriteNumber("ssim", m.StructuralSimilarity);
        json.WriteEndObject();
    }

    private static void WriteRecognition(Utf8JsonWriter json, Recognition r)
    {
        json.WriteStartObject("recognised");
        json.WriteString("agreesWhen", r.Change.Description);
        json.WriteString("turn", r.Change.Turn.ToString());
        json.WriteNumber("right", r.Change.Right);
        json.WriteNumber("down", r.Change.Down);
        json.WriteNumber("bytes", r.Change.Bytes);
        json.WriteBoolean("sidesSwapped", r.Change.SidesSwapped);
        switch (r.Change.Colors)
        {
            case ChannelOrder order: json.WriteString("channels", order.Order); break;
            case Tone { IsInverted: true }: json.WriteBoolean("inverted", true); break;
            case Tone { IsSrgb: true }: json.WriteBoolean("srgb", true); break;
            case Tone { Exponent: { } exponent }: json.WriteNumber("exponent", exponent); break;
            case Tone { Factor: { } factor, Offset: { } offset }:
                json.WriteNumber("factor", factor);
                json.WriteNumber("offset", offset);
                break;
        }
        json.WriteString("verdict", ComparisonText.Of(r.Likeness));
        json.WriteNumber("wrong", r.Difference.Wrong);
        json.WriteNumber("offByOne", r.Difference.OffByOne);
        json.WriteEndObject();
    }

    private static void WriteModels(Utf8JsonWriter json, Scene scene, SceneDifference s)
    {
        json.WriteStartObject("scene");
        json.WriteBoolean("referenceIsItsPicture", s.IsReferenceOwn);
        if (!s.IsReferenceOwn) json.WriteBoolean("mineIsItsPicture", s.IsMineOwn);
        json.WriteStartArray("models");
        foreach (var model in s.Models)
        {
            json.WriteStartObject();
            WriteName(json, scene, model.Model);
            json.WriteNumber("pixels", model.Pixels);
            json.WriteNumber("wrong", model.Wrong);
            json.WriteNumber("share", model.Share);
            json.WriteBoolean("missing", model.IsMissing);
            WriteColor(json, "color", model.Color);
            if (model.OtherColor is { } other) WriteColor(json, "otherColor", other);
            json.WriteStartArray("shows");
            foreach (var (shown, pixels) in model.Shows)
            {
                json.WriteStartObject();
                WriteName(json, scene, shown);
                json.WriteNumber("pixels", pixels);
                json.WriteEndObject();
            }
            json.WriteEndArray();
            json.WriteEndObject();
        }
        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static void WriteName(Utf8JsonWriter json, Scene scene, int model)
    {
        json.WriteNumber("model", model);
        json.WriteString("name", model < 0 ? "background" : scene.Models[model].Name);
        if (model >= 0) json.WriteString("type", scene.Models[model].Kind);
    }

    private static void WriteColor(Utf8JsonWriter json, string name, Color color)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(color.R);
        json.WriteNumberValue(color.G);
        json.WriteNumberValue(color.B);
        json.WriteEndArray();
    }

    private static void WriteBytes(Utf8JsonWriter json, string name, (byte R, byte G, byte B) color)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(color.R);
        json.WriteNumberValue(color.G);
        json.WriteNumberValue(color.B);
        json.WriteEndArray();
    }
}
