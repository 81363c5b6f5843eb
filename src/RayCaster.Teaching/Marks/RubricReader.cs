using System.Security.Cryptography;

namespace RayCaster.Teaching;

/// <summary>Makes a <see cref="Rubric"/> of a file, JSON as in a scene file, or says all that is wrong with it.</summary>
public static class RubricReader
{
    /// <summary>The most pixels that a scene may have: mistakes show in small pictures, and there are many of them.</summary>
    public const int MaxPixels = 2_000_000;

    private static readonly string[] places = ["{dir}", "{scene}", "{out}", "{name}"];

    /// <summary>Reads a file and the scenes that it names.</summary>
    /// <param name="report">All that is wrong with it and its scenes, as text for people; empty if nothing is.</param>
    /// <returns>The rubric, or null if there is an error.</returns>
    public static Rubric? Read(string path, out string report)
    {
        var sceneReports = new StringBuilder();
        var rubric = ShortFile.Read(path, "the rubric", o => ReadRubric(o, path, sceneReports), out report);
        report += sceneReports;
        return rubric;
    }

    /// <summary>Reads the outermost object; without text it describes the keys.</summary>
    internal static Rubric? ReadRubric(SceneObject o, string path, StringBuilder sceneReports)
    {
        using var digest = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        if (o.Document is { } document) digest.AppendData(document.Text.Utf8);
        o.Text("$schema", "Where editors find the schema of rubrics; the program does not use it.", false);
        var title = o.Text("title", "What is marked, for the heads of pages.", false) ?? "Marks";
        var files = o.Texts("scenes", "The scene files, an array of paths that start at the rubric's folder.", true);
        var source = ReadSource(o, Path.GetDirectoryName(Path.GetFullPath(Path.Combine(".", path))) ?? "/");
        if (files.Count > 1 && source.Run.Count == 0 && !source.Pictures.Contains("{name}"))
            o.Refuse("pictures", $" must contain {"{name}"}, the scene's name, since there are {files.Count} scenes");
        var vary = o.Flag("vary",
            "Whether programs draw variations of the scenes, which nobody knows before: then a program that copies pictures fails.");
        if (vary && source.Run.Count == 0 && o.IsSound) o.Refuse("vary", $" needs run: pictures that are there already show the scenes as they are");
        var tests = ReadTests(o, source, Path.GetDirectoryName(Path.GetFullPath(Path.Combine(".", path))) ?? "/", digest);
        var hint = o.OptionalChoice("hint", "How much of a hint the students' pages tell: what is to be seen, what to ask oneself, or nothing.",
            "question", "symptom", "none");
        var items = new List<RubricItem>();
        foreach (var element in o.Objects("items", "What has points of its own, an array of items.")) items.Add(ReadItem(element, items));
        o.Close();
        if (!o.Has("tests") && items.FindIndex(item => item.Step > 0) is >= 0 and var tested)
            o.Refuse("items", $" has a step, which needs tests: a hand-out whose tests are built", tested);
        if (o.Has("items") && items.Count == 0 && o.IsSound) o.Refuse("items", $" must hold at least one item");

        var scenes = ReadScenes(o, files, Path.GetDirectoryName(path) ?? "", digest, sceneReports);
        return !o.IsSound || o.Document is null ? null : new(scenes, Convert.ToHexStringLower(digest.GetHashAndReset()))
        {
            Title = title,
            Path = Path.GetFullPath(path),
            Hint = hint switch { "question" => HintLevel.Question, "symptom" => HintLevel.Symptom, _ => null },
            Items = items,
            Vary = vary,
            Source = source,
            Tests = tests,
        };
    }

    /// <summary>Reads an item; the mistakes of those before it are taken.</summary>
    internal static RubricItem ReadItem(SceneObject o, IReadOnlyList<RubricItem> before)
    {
        var name = o.Text("name", "What the item is called.", true) ?? "";
        var points = o.Number("points", "What it is worth.", Limits.From(0.01, 10_000)); // tables have two decimals
        var mistakes = o.Texts("mistakes", "The ids of the mistakes that cost points of it (docs/mistakes.md).", false);
        var undone = o.Texts("undone", $"What must be drawn for any of its points: {string.Join(", ", Diagnosis.Parts)}.", false);
        var each = o.Number("each", "What one of its mistakes costs; all of its points where it is left out.", Limits.Positive, points);
        var step = o.Whole("step", "The step of the hand-out whose tests decide; 0 for none.", 0, LabSteps.Count, 0);
        var by = o.OptionalChoice("by", "What decides: the pictures, the tests of its step, or both; where these contradict each other, you do.",
            step > 0 ? "both" : "pictures", step > 0 ? "pictures" : "both", "tests");
        var remark = o.Text("remark", "What the students' pages say of it, whatever was found.", false);
        o.Close();
        if (before.Any(item => item.Name == name))
            o.Refuse("name", $" is \"{name}\", which another item is called already: tables and pages tell items apart by their names");
        if (each > points) o.Refuse("each", $" must be at most the item's points, {points}, but is {each}");
        var ids = MistakeCatalog.All.Select(mistake => mistake.Id).ToArray();
        for (var i = 0; i < mistakes.Count; i++)
        {
            if (!ids.Contains(mistakes[i]))
                o.Refuse("mistakes", $" must be the id of a known mistake, but is \"{mistakes[i]}\"{Spelling.DidYouMean(mistakes[i], ids)}", i);
            else if (before.FirstOrDefault(item => item.Mistakes.Contains(mistakes[i])) is { } other)
                o.Refuse("mistakes", $" is {mistakes[i]}, which costs points of \"{other.Name}\" already: a mistake belongs to one item", i);
        }
        RefuseUnknown(o, "undone", undone, Diagnosis.Parts);
        if (undone.Contains("triangle")) undone = [.. undone, "mesh"]; // a mesh is its triangles
        if (by != "pictures" && step == 0) o.Refuse("by", $" needs step: the step of the hand-out whose tests decide");
        return new(name, points, each, mistakes, undone)
        {
            Remark = remark,
            Evidence = Enum.Parse<ItemEvidence>(by, ignoreCase: true),
            Step = by == "pictures" ? 0 : step,
        };
    }

    /// <summary>Finds the built tests of the hand-out that a rubric names.</summary>
    private static string? ReadTests(SceneObject o, PictureSource source, string folder, IncrementalHash digest)
    {
        var handOut = o.FileName("tests",
            $"Your copy of the hand-out, with built tests: they are run with the {StepTests.Lab} of each submission.", false);
        if (handOut is null) return null;
        var tests = StepTests.BuiltIn(Path.GetFullPath(handOut, folder));
        if (tests is null) o.Refuse("tests", $" must be a hand-out whose tests are built: raycaster handout LAB --solution, then dotnet build LAB");
        else foreach (var file in Directory.GetFiles(tests, "*.dll").Order(StringComparer.Ordinal)) digest.AppendData(File.ReadAllBytes(file));
        if (!source.Run.Any(word => word.EndsWith("/" + StepTests.Lab, StringComparison.Ordinal)))
            o.Refuse("tests", $" needs run with the path of {StepTests.Lab}, as in {"{dir}"}/bin/{StepTests.Lab}");
        return tests;
    }

    private static PictureSource ReadSource(SceneObject o, string folder)
    {
        var pictures = o.FileName("pictures",
            "The file of a picture in the submission's folder; {name} stands for the scene's name. Default: {name}.png, or {name}.ppm.", false);
        var run = o.Texts("run",
            "The command that draws a picture, word by word; {dir} stands for the submission's folder, {scene} for the scene file, " +
            "{out} for the picture to write.", false);
        var build = o.Texts("build", "A command that is run once for each submission before; {dir} stands for its folder.", false);
        var time = o.Number("timeLimit", "How long a picture may take, in seconds.", Limits.From(0.1, 3600), 20);
        var buildTime = o.Number("buildTimeLimit", "How long building may take, in seconds.", Limits.From(0.1, 3600), 120);
        var output = o.Number(
            "outputLimit", "How much a program may print, and how large a file it writes may be, in megabytes.", Limits.From(0.1, 1024), 64);
        var memory = o.Number(
            "memoryLimit", "How much memory the processes of a program may hold together, in megabytes.", Limits.From(16, 1 << 20), 2048);
        var processes = o.Whole("processLimit", "How many processes a program may be.", 1, 10_000, 100);
        var network = o.OptionalChoice(
            "network", "Whether programs may use the network, where that can be forbidden.", "none", "allowed") == "allowed";
        var environment = o.Texts("environment", "The names of further variables of your environment that programs get, an array.", false);
        var readable = o.Texts("readable",
            "Further files and folders that programs may read, where others are hidden from them, an array of paths from the rubric's folder.",
            false);

        if (pictures is not null && o.Has("run"))
            o.Refuse("pictures", $" and run exclude each other: the pictures are there, or a command draws them");
        if (o.Has("build") && !o.Has("run")) o.Refuse("build", $" needs run: the command that draws a picture");
        if (pictures is "") o.Refuse("pictures", $" must be the path of a picture, but is \"\"");
        if (o.Has("run") && run.Count == 0 && o.IsSound) o.Refuse("run", $" must begin with a program");
        if (run.Count > 0)
            foreach (var needed in (ReadOnlySpan<string>)["{scene}", "{out}"])
                if (!run.Any(word => word.Contains(needed))) o.Refuse("run", $" must say where {needed} goes");
        foreach (var (key, command) in (ReadOnlySpan<(string, IReadOnlyList<string>)>)[("run", run), ("build", build)])
        {
            if (command is ["", ..]) o.Refuse(key, $" must be a program, but is \"\"", 0);
            RefuseUnknown(o, key, command, places, " or a word", word => word is not ['{', .., '}']);
            WarnOfMissingProgram(o, key, command);
        }
        const double megabyte = 1e6;
        var limits = o.IsSound
            ? new ProgramLimits(
                TimeSpan.FromSeconds(time), TimeSpan.FromSeconds(buildTime), (long)(output * megabyte), (long)(memory * megabyte),
                processes, network)
            {
                Environment = environment,
                Readable = [.. readable.Select(file => Path.GetFullPath(file, folder))],
            }
            : new(default, default, 0, 0, 0, false);
        return new(pictures ?? "{name}.png", build, run, limits);
    }

    private static void RefuseUnknown(SceneObject o, string key, IReadOnlyList<string> words, IReadOnlyList<string> known,
        string orElse = "", Predicate<string>? isElse = null)
    {
        foreach (var (i, word) in words.Index())
            if (!known.Contains(word) && isElse?.Invoke(word) != true)
                o.Refuse(key, $" must be one of {string.Join(", ", known)}{orElse}, but is \"{word}\"{Spelling.DidYouMean(word, known)}", i);
    }

    private static void WarnOfMissingProgram(SceneObject o, string key, IReadOnlyList<string> words)
    {
        // A path may be different for each submission; Windows also tries names with endings.
        if (OperatingSystem.IsWindows() || words is not [{ Length: > 0 } program, ..] || program.AsSpan().ContainsAny('/', '{')) return;
        var folders = (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator);
        if (!folders.Any(folder => File.Exists(Path.Combine(folder, program))))
            o.Warn(key, $": no folder of PATH has a program {program}; is it installed?");
    }

    /// <summary>A path without "..", for messages: from the current folder, if it is not absolute.</summary>
    private static string Plain(string path) => Path.IsPathRooted(path) ? Path.GetFullPath(path) : Path.GetRelativePath(".", path);

    private static List<MarkedScene> ReadScenes(
        SceneObject o, IReadOnlyList<string> files, string folder, IncrementalHash digest, StringBuilder reports)
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
            digest.AppendData(reading.Text.Span);
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
                scenes.Add(new(name, Path.GetFullPath(path), reading.Text, new(scene)));
        }
        if (o.IsSound) foreach (var scene in scenes) digest.AppendData(scene.Right.Rgb); // which also depends on mesh files and on src/RayCaster
        return scenes;
    }
}
