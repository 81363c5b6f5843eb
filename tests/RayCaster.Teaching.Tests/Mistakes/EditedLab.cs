using System.Collections.Concurrent;
using System.Reflection;
using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;

namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>The lab that is handed out (src/RayCaster.Lab), with mistakes: its source is edited, compiled and run.</summary>
internal static partial class EditedLab
{
    private const string Entry = """
        global using System;
        global using System.Collections.Generic;
        global using System.Linq;
        public static class Entry
        {
            public static RayCaster.Picture Draw(RayCaster.Scene scene) => Lab.SceneFile.Of(scene).Draw();
        }
        """;

    private const string PixelEntry = """
        global using System;
        global using System.Collections.Generic;
        global using System.IO;
        global using System.Linq;
        global using System.Threading;
        public static class Entry
        {
            public static IEnumerable<(string, Func<object>)> Calls(RayCaster.Scene scene, int c, int r)
            {
                Lab.Todo.Listen();
                return Lab.Pixel.Calls(scene, c, r);
            }
            public static IEnumerable<string> Notes() => Lab.Todo.NotWritten;
        }
        """;

    private static readonly string[] files =
        ["Aabb", "Camera", "Circle", "Color", "Model", "Plane", "Ray", "Scene", "SceneFile", "Sphere", "Triangle", "Vector3"];

    private static readonly Dictionary<string, string> source =
        files.ToDictionary(file => file, Read);

    private static string Read(string file) =>
        File.ReadAllText(Directory.GetFiles(ProjectFolder.PathOf("src/RayCaster.Lab"), $"{file}.cs", SearchOption.AllDirectories).Single());

    private static readonly MetadataReference[] references =
    [
        .. ((Assembly[])[
            typeof(object).Assembly, typeof(Enumerable).Assembly, Assembly.Load("System.Runtime"), typeof(Scene).Assembly,
            typeof(PixelNumbers).Assembly])
            .Select(assembly => MetadataReference.CreateFromFile(assembly.Location)),
    ];

    /// <summary>All programs are made from this one, so that the references are read once.</summary>
    private static readonly CSharpCompilation empty = CSharpCompilation.Create(
        "EditedLab", [], references, new(OutputKind.DynamicallyLinkedLibrary, optimizationLevel: OptimizationLevel.Release));

    /// <summary>Of texts: most files are the same in most programs.</summary>
    private static readonly ConcurrentDictionary<string, SyntaxTree> trees = [];

    private static readonly ConcurrentDictionary<(Manner, string), Lazy<Func<Scene, Picture>>> programs = [];

    /// <summary>The picture that a program with these mistakes writes; two of them turn its size.</summary>
    public static Picture Render(Scene scene, params PlantedMistake[] mistakes) => Render(scene, Manner.OfTheSlides, mistakes);

    /// <summary>The same in the program's own manner; where two change one line, the first has it.</summary>
    public static Picture Render(Scene scene, Manner manner, params PlantedMistake[] mistakes) =>
        programs.GetOrAdd((manner, string.Join(' ', mistakes.Select(mistake => mistake.Id))), _ => new(() => Compile(Edited(manner, mistakes), Entry)
            .GetMethod("Draw")!.CreateDelegate<Func<Scene, Picture>>())).Value(scene);

    /// <summary>What "--pixel" prints of the lab in which the first place of a text in a file is replaced.</summary>
    /// <param name="limit">How many seconds a body may take; as students have it, if null.</param>
    public static string PixelOf(Scene scene, int column, int line, string hint, string file, string old, string @new, double? limit)
    {
        var text = new Dictionary<string, string>(source);
        foreach (var more in (string[])["Pixel", "Todo", "BodyCalls"])
            text[more] = Read(more);
        var start = text[file].IndexOf(old, StringComparison.Ordinal);
        if (start < 0) throw new InvalidOperationException($"the lab's {file}.cs does not have \"{old}\"");
        text[file] = text[file][..start] + @new + text[file][(start + old.Length)..];
        var entry = Compile(text.Values, PixelEntry);
        var calls = entry.GetMethod("Calls")!.CreateDelegate<Func<Scene, int, int, IEnumerable<(string, Func<object>)>>>();
        var notes = entry.GetMethod("Notes")!.CreateDelegate<Func<IEnumerable<string>>>();
        using var output = new StringWriter { NewLine = "\n" };
        PixelNumbers.Print(output, scene, [$"{column}", $"{line}", "--hint", hint], (c, r) => calls(scene, c, r), notes,
            limit is { } seconds ? TimeSpan.FromSeconds(seconds) : null);
        return output.ToString();
    }

    /// <summary>The files with the mistakes' edits and the manner's.</summary>
    /// <exception cref="InvalidOperationException">The lab does not have an edit's text once.</exception>
    private static IEnumerable<string> Edited(Manner manner, PlantedMistake[] mistakes)
    {
        var text = new Dictionary<string, string>(source);
        foreach (var (file, old, @new) in mistakes.SelectMany(mistake => mistake.Edits).Concat(manner.Edits))
        {
            if (source[file].Split(old).Length != 2)
                throw new InvalidOperationException($"the lab's {file}.cs must have \"{old}\" once: PlantedMistake.cs edits it");
            text[file] = text[file].Replace(old, @new, StringComparison.Ordinal);
        }
        return manner.Float ? text.Select(file => InFloats(file.Key, file.Value)) : text.Values;
    }

    private static string InFloats(string file, string text)
    {
        if (file == "SceneFile") text = NumberOfTheScene().Replace(text, "(float)$0");
        text = text.Replace("double", "float", StringComparison.Ordinal);
        return DecimalLiteral().Replace(OfMath().Replace(text, "MathF.$1"), "$0f");
    }

    private static Type Compile(IEnumerable<string> texts, string entry)
    {
        var compilation = empty.AddSyntaxTrees(
            texts.Append(entry).Select(text => trees.GetOrAdd(text, text => CSharpSyntaxTree.ParseText(text))));
        using var bytes = new MemoryStream();
        var result = compilation.Emit(bytes);
        if (!result.Success) throw new InvalidOperationException(string.Join('\n', result.Diagnostics));
        return Assembly.Load(bytes.ToArray()).GetType("Entry")!;
    }

    [GeneratedRegex(@"\b(view|v|c|s)\.(FovY|ZNear|ZFar|Bias|Radius|[XYZRGB])\b")]
    private static partial Regex NumberOfTheScene();

    [GeneratedRegex(@"\bMath\.(Sqrt|Tan|PI)\b")]
    private static partial Regex OfMath();

    [GeneratedRegex(@"\b\d+(\.\d+|e-?\d+)\b")]
    private static partial Regex DecimalLiteral();
}
