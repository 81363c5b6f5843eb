using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;

namespace RayCaster.Engine.Tests;

/// <summary>The engine's folders are floors: none names a type of a floor above it, or of another folder on its own floor.</summary>
public partial class FloorTests
{
    private static readonly string[][] floors =
    [
        ["Schedule"], ["Numbers"], ["Screen"], ["Bytes"], ["Shapes", "Meshes"], ["."],
    ];

    [Fact]
    public void NoFolderNamesOneAboveIt()
    {
        var sources = Sources();
        Assert.Equal(floors.SelectMany(floor => floor).Order(), sources.Select(source => source.Folder).Distinct().Order());
        var owners = sources.SelectMany(source => source.Declared.Select(name => (Name: name, source.Folder)))
            .ToLookup(owner => owner.Name, owner => owner.Folder);
        var found = new List<string>();
        foreach (var source in sources)
        {
            foreach (Match word in Word().Matches(source.Code))
            {
                if (source.Declared.Contains(word.Value) || owners[word.Value].Contains(source.Folder)) continue;
                foreach (var owner in owners[word.Value].Where(owner => FloorOf(owner) >= FloorOf(source.Folder)))
                    found.Add($"{source.File}({1 + source.Code.AsSpan(0, word.Index).Count('\n')}): {word.Value} of {owner}");
            }
        }
        Assert.Empty(found.Distinct());
    }

    [Fact]
    public void AWordInACommentOrAStringNamesNothing() =>
        Assert.Equal(
            "  class A  \n\n{ _ = ; }",
            CommentOrString().Replace("/* B */ class A // C\n\n{ _ = \"D\"; }", match => match.Value[0] == '/' ? " " : ""));

    private static int FloorOf(string folder) => Array.FindIndex(floors, floor => floor.Contains(folder));

    private static List<(string File, string Folder, string Code, string[] Declared)> Sources([CallerFilePath] string here = "")
    {
        var root = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(here)!, "../../src/RayCaster.Engine"));
        var sources = new List<(string, string, string, string[])>();
        foreach (var file in Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories))
        {
            var folder = Path.GetRelativePath(root, Path.GetDirectoryName(file)!);
            if (folder.Split(Path.DirectorySeparatorChar)[0] is "bin" or "obj") continue;
            // lines stay where they are
            var code = CommentOrString().Replace(File.ReadAllText(file), match => new string('\n', match.Value.Count(c => c == '\n')));
            sources.Add((Path.GetRelativePath(root, file), folder, code, [.. Declaration().Matches(code).Select(match => match.Groups[1].Value)]));
        }
        return sources;
    }

    [GeneratedRegex("""//[^\n]*|/\*.*?\*/|\$?"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\])'""", RegexOptions.Singleline)]
    private static partial Regex CommentOrString();

    /// <summary>Not the nested ones: those are indented.</summary>
    [GeneratedRegex(@"^(?:public |internal )?(?:abstract |sealed |static |readonly |ref |partial )*" +
        @"(?:class|interface|enum|record struct|struct|record) (\w+)", RegexOptions.Multiline)]
    private static partial Regex Declaration();

    [GeneratedRegex(@"(?<!\.)\b[A-Z]\w*\b")]
    private static partial Regex Word();
}
