namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>What a wrong program draws. The tables of tests write programs as parts with an ampersand between them.</summary>
internal static class ProgramInWords
{
    /// <summary>A length without its root, in a program that uses it where the slides do not.</summary>
    private static readonly PlantedMistake lengthInAll = new("length in all", "",
        new("Vector3", "Math.Sqrt(this * this)", "this * this"),
        new("Camera", "ray.HitParameter / (2 * (Target - Position)).Length",
            "(ray.At(ray.HitParameter) - Position).Length / (2 * (Target - Position).Length)"),
        new("Sphere", "if (D * D > R * R)", "D = new(D.Length, 0, 0); if (D * D > R * R)"));

    /// <param name="scene">The scene that the program reads.</param>
    /// <param name="words">
    /// Each part is a planted mistake's id; an edit of the lab's source ("Circle: X - C → C - X", or another body "triangle: …"); shapes that are
    /// not drawn ("without plane aabb"); another number of the camera ("fovY 52"); a manner ("truncates"); or of formulas: another right style
    /// ("style sphere abc"), a mistake of the catalogue ("formulas rows"), or one that is written out ("formula plane t = Q·n / den"). Then the
    /// formulas draw, otherwise the lab.
    /// </param>
    public static Picture Draw(Scene scene, string words)
    {
        var (manner, mistakes, formulas) = (Manner.OfTheSlides, new List<PlantedMistake>(), new List<Change>());
        string[] style = [];
        foreach (var part in words.Split(" & "))
        {
            var (kind, rest) = part.Split(' ', 2) is [var first, var other] ? (first, other) : (part, "");
            if (part.Split(" → ") is [var old, var @new] && kind is [.. var file, ':'])
                mistakes.Add(PlantedMistake.Of(new SourceEdit(file, old[(kind.Length + 1)..], @new)));
            else if (kind == "triangle:") mistakes.Add(PlantedMistake.Of(SourceEdit.OfTriangle(rest)));
            else if (kind == "without") scene = scene with { Models = [.. scene.Models.Where(model => !rest.Split(' ').Contains(model.Kind))] };
            else if (kind is "target" or "fovY" or "zFar") scene = scene with { Camera = Changed(scene.Camera, kind, rest) };
            else if (kind == "formulas") formulas.Add(MistakeCatalog.Named(rest)!.Usual);
            else if (kind == "formula") formulas.Add(Written(rest));
            else if (kind == "style") style = rest.Split(' ');
            else if (part == "truncates") manner = manner with { Truncates = true };
            else if (part == "float") manner = manner with { Float = true };
            else if (part == "other formulas") manner = manner with { OtherFormulas = true };
            else if (part != "ok") mistakes.Add(part == lengthInAll.Id ? lengthInAll : PlantedMistake.Named(part));
        }
        if (style is [var step, var way])
            return FormulaProgram.Slides.With(FormulaBook.Slides[Enum.Parse<StepKind>(step, ignoreCase: true), way]).Draw(scene);
        return formulas.Count > 0 ? MistakeCatalog.Draw(scene, formulas) : EditedLab.Render(scene, manner, [.. mistakes]);
    }

    /// <summary>A mistake that the catalogue does not have, as Mistakes.txt has its own.</summary>
    public static Change Written(string formulas) => new([.. ChangeReader.Read(formulas).Single()], Priors.Known) { Cause = formulas };

    private static Camera Changed(Camera camera, string name, string value)
    {
        double[] numbers = [.. value.Split(' ').Select(number => double.Parse(number, CultureInfo.InvariantCulture))];
        return name switch
        {
            "target" => camera with { Target = new(numbers[0], numbers[1], numbers[2]) },
            "fovY" => camera with { FovY = numbers[0] },
            _ => camera with { ZFar = numbers[0] },
        };
    }
}
