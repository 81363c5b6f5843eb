using System.Text;
using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>
/// An explanation for programs: JSON with every number in full, so that it reads back as the same double. What JSON has no number for
/// stands as the text "NaN", "Infinity" or "-Infinity". docs/explain.md lists the fields.
/// </summary>
internal sealed class ExplanationJson
{
    private readonly Utf8JsonWriter json;

    private ExplanationJson(Utf8JsonWriter json) => this.json = json;

    /// <summary>The whole of it.</summary>
    /// <param name="pixel">The pixel.</param>
    /// <param name="reference">What another picture has there; null for none.</param>
    public static string Of(PixelExplanation pixel, ReferenceExplanation? reference = null)
    {
        using var bytes = new MemoryStream();
        using (var writer = new Utf8JsonWriter(bytes, JsonForm.Options))
            new ExplanationJson(writer).Write(pixel, reference);
        return Encoding.UTF8.GetString(bytes.ToArray()) + "\n";
    }

    private void Write(PixelExplanation pixel, ReferenceExplanation? reference)
    {
        json.WriteStartObject();
        Object("pixel", () =>
        {
            json.WriteNumber("column", pixel.Column);
            json.WriteNumber("line", pixel.Line);
            json.WriteNumber("row", pixel.Row);
            json.WriteNumber("width", pixel.Scene.Camera.Width);
            json.WriteNumber("height", pixel.Scene.Camera.Height);
        });
        Object("camera", () => Camera(pixel));
        Object("ray", () => Ray(pixel));
        List("models", pixel.Models, Model);
        Object("others", () => Others(pixel.Others));
        Hit(pixel);
        Object("color", () => Color(pixel));
        json.WriteStartArray("notes");
        foreach (var note in pixel.Notes) json.WriteStringValue(note);
        json.WriteEndArray();
        if (reference is not null) Object("reference", () => Reference(reference));
        json.WriteEndObject();
    }

    private void Camera(PixelExplanation pixel)
    {
        var camera = pixel.Scene.Camera;
        Vector("position", camera.Position);
        Vector("target", camera.Target);
        Vector("up", camera.Up);
        Number("fovY", camera.FovY);
        Number("zNear", camera.ZNear);
        Number("zFar", camera.ZFar);
        Number("bias", camera.Bias);
        json.WriteString("clip", camera.Clip == Clip.Depth ? "depth" : "distance");
        json.WriteString("sample", camera.Sample == Sample.Corner ? "corner" : "center");
        Number("reach", camera.Reach);
        json.WriteString("slide", Slides.Camera);
        List("steps", pixel.CameraSteps, Step);
    }

    private void Ray(PixelExplanation pixel)
    {
        Vector("origin", pixel.Ray.Origin);
        Vector("direction", pixel.Ray.Direction);
        Number("zPerT", pixel.Ray.ZPerT);
        json.WriteString("slide", Slides.PixelTranslation);
        List("steps", pixel.RaySteps, Step);
    }

    private void Model(ModelExplanation model)
    {
        json.WriteNumber("index", model.Index);
        json.WriteString("name", model.Name);
        json.WriteString("type", model.Type);
        json.WriteString("verdict", Word(model.Verdict));
        json.WriteString("reason", model.Reason);
        if (Slides.OfShape(model.Type) is { } slide) json.WriteString("slide", slide);
        if (model.Beside is { } beside) json.WriteString("beside", beside);
        if (model.Mesh is { } mesh) Object("mesh", () => Mesh(mesh));
        List("steps", model.Steps, Step);
        if (model.Slabs.Count > 0) List("slabs", model.Slabs, Slab);
        if (model.Weights is { } weights) Numbers("weights", weights);
        List("crossings", model.Crossings, Crossing);
    }

    private void Mesh(MeshExplanation mesh)
    {
        json.WriteNumber("triangles", mesh.Triangles);
        if (mesh.Triangle is { } triangle) json.WriteNumber("triangle", triangle);
        else json.WriteNull("triangle");
        json.WriteNumber("missed", mesh.Missed);
        json.WriteNumber("behind", mesh.Behind);
        json.WriteNumber("underBias", mesh.UnderBias);
        json.WriteNumber("beforeNear", mesh.BeforeNear);
        json.WriteNumber("beyondFar", mesh.BeyondFar);
        json.WriteNumber("counting", mesh.Counting);
    }

    private void Slab(SlabExplanation slab)
    {
        json.WriteString("axis", slab.Axis.ToString());
        Number("lo", slab.Lo);
        Number("hi", slab.Hi);
        Number("t0", slab.T0);
        Number("t1", slab.T1);
        Number("enters", slab.Enters);
        Number("leaves", slab.Leaves);
        json.WriteBoolean("decidesEntry", slab.DecidesEntry);
        json.WriteBoolean("decidesExit", slab.DecidesExit);
    }

    private void Crossing(CrossingExplanation crossing)
    {
        Number("t", crossing.T);
        Number("z", crossing.Z);
        json.WriteString("verdict", Word(crossing.Verdict));
        json.WriteString("refusal", Word(crossing.Refusal));
        json.WriteString("reason", crossing.Reason);
        if (crossing.Untested is { } t) Number("untested", t);
        json.WriteString("numbers", crossing.Numbers);
    }

    private void Others(OtherModels others)
    {
        json.WriteNumber("count", others.Count);
        json.WriteNumber("hidden", others.Hidden);
        json.WriteNumber("behind", others.Behind);
        json.WriteNumber("underBias", others.UnderBias);
        json.WriteNumber("beforeNear", others.BeforeNear);
        json.WriteNumber("beyondFar", others.BeyondFar);
        json.WriteNumber("missed", others.Missed);
    }

    private void Hit(PixelExplanation pixel)
    {
        if (pixel.Winner is not { } index)
        {
            json.WriteNull("hit");
            return;
        }
        Object("hit", () =>
        {
            json.WriteNumber("model", index);
            json.WriteString("name", pixel.NameOf(index));
            Number("t", pixel.Ray.HitParameter);
            Vector("point", pixel.Ray.At(pixel.Ray.HitParameter));
            json.WriteStartArray("hides");
            foreach (var trial in pixel.Trials)
                if (trial.Hit is { } t && trial.Index != index)
                {
                    json.WriteStartObject();
                    json.WriteNumber("model", trial.Index);
                    Number("t", t);
                    json.WriteEndObject();
                }
            json.WriteEndArray();
        });
    }

    private void Color(PixelExplanation pixel)
    {
        if (pixel.AttenuationSteps is [.., { } attenuation]) Number("attenuation", attenuation.Value);
        else json.WriteNull("attenuation");
        var full = pixel.Ray.HitModel?.Color ?? pixel.Scene.Background;
        Numbers("full", [full.R, full.G, full.B]);
        Numbers("value", [pixel.Color.R, pixel.Color.G, pixel.Color.B]);
        Bytes("bytes", pixel.Bytes);
        json.WriteString("slide", Slides.Shading);
        List("steps", [.. pixel.AttenuationSteps, .. pixel.ColorSteps], Step);
    }

    private void Reference(ReferenceExplanation reference)
    {
        Bytes("bytes", reference.Bytes);
        Bytes("difference", reference.Difference);
        json.WriteBoolean("agrees", reference.Agrees);
        json.WriteStartArray("causes");
        foreach (var cause in reference.Causes) json.WriteStringValue(cause);
        json.WriteEndArray();
    }

    private void Step(FormulaStep step)
    {
        json.WriteString("name", step.Name);
        json.WriteString("formula", step.Formula);
        json.WriteString("numbers", step.Numbers);
        if (step.IsTest) json.WriteBoolean("value", step.Value != 0);
        else if (step.Values is [var only]) Number("value", only);
        else Numbers("value", step.Values);
    }

    private static string Word(Enum value) => JsonNamingPolicy.CamelCase.ConvertName(value.ToString());

    private void Object(string name, Action write)
    {
        json.WriteStartObject(name);
        write();
        json.WriteEndObject();
    }

    private void List<T>(string name, IReadOnlyList<T> items, Action<T> write)
    {
        json.WriteStartArray(name);
        foreach (var item in items)
        {
            json.WriteStartObject();
            write(item);
            json.WriteEndObject();
        }
        json.WriteEndArray();
    }

    private void Vector(string name, Vector3 v) => Numbers(name, [v.X, v.Y, v.Z]);

    private void Bytes(string name, (int R, int G, int B) bytes) => Numbers(name, [bytes.R, bytes.G, bytes.B]);

    private void Numbers(string name, IReadOnlyList<double> values)
    {
        json.WriteStartArray(name);
        foreach (var value in values) Value(value);
        json.WriteEndArray();
    }

    private void Number(string name, double value)
    {
        json.WritePropertyName(name);
        Value(value);
    }

    private void Value(double value)
    {
        if (double.IsFinite(value)) json.WriteNumberValue(value);
        else json.WriteStringValue(double.IsNaN(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity");
    }
}
