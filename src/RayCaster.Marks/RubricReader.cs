namespace RayCaster.Marks;

/// <summary>Makes a <see cref="Rubric"/> of a file, JSON as in a scene file, or reports all that is wrong with it.</summary>
public static class RubricReader
{
    /// <summary>The most pixels that a scene may have: mistakes show in small pictures, and there are many of them.</summary>
    public const int MaxPixels = 2_000_000;

    /// <summary>Reads a file and the scenes that it names.</summary>
    /// <param name="report">All that is wrong with it and its scenes, as text for people; empty if nothing is.</param>
    /// <returns>The rubric, or null if there is an error.</returns>
    public static Rubric? Read(string path, out string report)
    {
        var sceneReports = new StringBuilder();
        var rubric = SceneReader.ReadShort(path, "the rubric", o => ReadRubric(o, path, sceneReports), out var reading);
        report = reading.Report() + sceneReports;
        return rubric;
    }

    /// <summary>Reads the outermost object; without text it describes the keys.</summary>
    internal static Rubric? ReadRubric(JsonKeys o, string path, StringBuilder sceneReports)
    {
        o.Text("$schema", "Where editors find the schema of rubrics; the program does not use it.", false);
        var title = o.Text("title", "What is marked, for the heads of pages.", false) ?? "Marks";
        var files = o.Texts("scenes", "The scene files, an array of paths that start at the rubric's folder.", true);
        var pictures = o.FileName("pictures",
            "The file of a picture in a student's folder; {name} stands for the scene's name. Default: {name}.png, or {name}.ppm.");
        if (pictures is "") o.Refuse("pictures", $" must be the path of a picture, but is \"\"");
        if (pictures is not null && files.Count > 1 && !pictures.Contains("{name}"))
            o.Refuse("pictures", $" must contain {"{name}"}, the scene's name, since there are {files.Count} scenes");
        var tests = o.FileName("tests",
            "The file of test results (JUnit or TRX) in a student's folder, such as results.xml; * and ? stand for any characters.");
        var hint = o.OptionalChoice("hint", "How much of a hint the students' pages tell: what is to be seen, what to ask oneself, or nothing.",
            "question", "symptom", "none");
        var items = new List<RubricItem>();
        foreach (var element in o.Objects("items", "What has points of its own, an array of items.")) items.Add(ReadItem(element, items));
        o.Close();
        if (tests is null && items.FindIndex(item => item.Step > 0) is >= 0 and var tested)
            o.Refuse("items", $" has a step, which needs tests: the file of test results in a student's folder", tested);
        if (o.Has("items") && items.Count == 0 && o.IsSound) o.Refuse("items", $" must hold at least one item");

        var scenes = ReadScenes(o, files, Path.GetDirectoryName(path) ?? "", sceneReports);
        return !o.IsSound ? null : new(scenes)
        {
            Title = title,
            Hint = hint switch { "question" => HintLevel.Question, "symptom" => HintLevel.Symptom, _ => null },
            Items = items,
            Pictures = pictures?.Replace('\\', '/') ?? "{name}.png",
            Tests = tests?.Replace('\\', '/'),
        };
    }

    /// <summary>Reads an item; the mistakes of those before it are taken.</summary>
    internal static RubricItem ReadItem(JsonKeys o, IReadOnlyList<RubricItem> before)
    {
        var name = o.Text("name", "What the item is called.", true) ?? "";
        var points = o.Number("points", "What it is worth.", Limits.From(0.01, 10_000)); // tables have two decimals
        var mistakes = o.Texts("mistakes", "The ids of the mistakes that cost points of it (docs/mistakes.md).", false);
        var undone = o.Texts("undone", $"What must be drawn for any of its points: {string.Join(", ", MissingPart.All)}.", false);
        var each = o.Number("each", "What one of its mistakes costs; all of its points where it is left out.", Limits.Positive, points);
        var step = o.Whole("step", "The step of the hand-out whose tests decide; 0 for none.", 0, LabSteps.Count, 0);
        var by = o.OptionalChoice("by", "What decides: the pictures, the tests of its step, or both; where these contradict each other, you do.",
            step > 0 ? "both" : "pictures", step > 0 ? "pictures" : "both", "tests");
        var remark = o.Text("remark", "What the students' pages say of it, whatever was found.", false);
        o.Close();
        if (before.Any(item => item.Name == name))
            o.Refuse("name", $" is \"{name}\", which another item is called already: tables and pages tell items apart by their names");
        if (each > points) o.Refuse("each", $" must be at most the item's points, {points}, but is {each}");
        RefuseUnknown(o, "mistakes", mistakes, [.. MistakeCatalog.All.Select(mistake => mistake.Id)], "the id of a known mistake");
        for (var i = 0; i < mistakes.Count; i++)
            if (before.FirstOrDefault(item => item.Mistakes.Contains(mistakes[i])) is { } other)
                o.Refuse("mistakes", $" is {mistakes[i]}, which costs points of \"{other.Name}\" already: a mistake belongs to one item", i);
        RefuseUnknown(o, "undone", undone, MissingPart.All, $"one of {string.Join(", ", MissingPart.All)}");
        if (undone.Contains("triangle")) undone = [.. undone, "mesh"]; // a mesh is its triangles
        if (by != "pictures" && step == 0) o.Refuse("by", $" needs step: the step of the hand-out whose tests decide");
        return new(name, points, each, mistakes, undone)
        {
            Remark = remark,
            Evidence = Enum.Parse<ItemEvidence>(by, ignoreCase: true),
            Step = by == "pictures" ? 0 : step,
        };
    }

    private static void RefuseUnknown(JsonKeys o, string key, IReadOnlyList<string> words, IReadOnlyList<string> known, string what)
    {
        foreach (var (i, word) in words.Index())
            if (!known.Contains(word)) o.Refuse(key, $" must be {what}, but is \"{word}\"{Spelling.DidYouMean(word, known)}", i);
    }

    /// <summary>A path without "..", for messages: from the current folder, if it is not absolute.</summary>
    private static string Plain(string path) => Path.IsPathRooted(path) ? Path.GetFullPath(path) : Path.GetRelativePath(".", path);

    private static List<MarkedScene> ReadScenes(JsonKeys o, IReadOnlyList<string> files, string folder, StringBuilder reports)
    {
        var scenes = new List<MarkedScene>();
        if (o.Has("scenes") && files.Count == 0 && o.IsSound) o.Refuse("scenes", $" must name at least one scene file");
        for (var i = 0; i < files.Count; i++)
        {
            if (files[i] is "")
            {
                o.Refuse("scenes", $" must be the path of a scene file, but is \"\"", i);
                continue;
            }
            var path = Plain(Path.Combine(folder, files[i].Replace('\\', '/')));
            var name = Path.GetFileNameWithoutExtension(path);
            var reading = SceneReader.Read(path);
            reports.Append(reading.Report());
            if (scenes.Exists(other => other.Name == name))
                o.Refuse("scenes", $" has a second scene that is called {name}: pictures are named after their scenes", i);
            if (reading.Scene is not { } scene)
                o.Refuse("scenes", $" cannot be used: {files[i]} has errors", i);
            else if (StoredReference.Contradiction(path, scene) is { } message)
                o.Refuse("scenes", $" cannot be used. {message}: undo the change in src/RayCaster", i);
            else if ((long)scene.Camera.Width * scene.Camera.Height > MaxPixels)
                o.Refuse("scenes", $" is too large: {scene.Camera.Width} x {scene.Camera.Height} pixels, the limit is {MaxPixels:N0} in all", i);
            else
                scenes.Add(new(name, new(scene)));
        }
        return scenes;
    }
}
