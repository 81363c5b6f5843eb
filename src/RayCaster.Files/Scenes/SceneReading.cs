namespace RayCaster.Files;

/// <summary>The reading of a scene file: what was found wrong, and at the end the scene.</summary>
public sealed class SceneReading
{
    /// <summary>After this many errors the rest of a file is not read, and after this many problems no warning is kept: a large file that is all
    /// mistakes would take hours.</summary>
    internal const int MaxProblems = 1000;

    internal const int Printed = 20;

    private const int LongestMessage = 2000; // a mesh file's path in it may have any length
    private readonly List<(bool IsError, int Start, int End, string Message)> findings = [];
    private readonly string folder;
    private readonly MissingFileHint names = new();
    private Dictionary<string, Lazy<MeshData>>? meshes; // by full path, each with its data or its exception; most scenes name none

    internal SceneReading(string name, ReadOnlyMemory<byte> utf8, string folder)
    {
        (Text, this.folder) = (utf8, folder);
        Source = new(name, utf8);
    }

    /// <summary>The scene; null if there is an error in it.</summary>
    public Scene? Scene { get; internal set; }

    /// <summary>The errors and warnings in the order of the file, at most about <see cref="MaxProblems"/>.</summary>
    public IReadOnlyList<Problem> Problems { get; internal set; } = [];

    /// <summary>The full paths of the mesh files that the scene names, also of those that could not be read.</summary>
    public IReadOnlyCollection<string> MeshFiles { get; private set; } = [];

    /// <summary>The file's bytes, also if they contain mistakes; empty if it cannot be read.</summary>
    public ReadOnlyMemory<byte> Text { get; }

    /// <summary>Whether the file cannot be read at all, for example because it is not there.</summary>
    public bool IsUnread => Problems.Any(problem => problem.IsError && problem.Line == 0);

    internal SourceText Source { get; }

    internal int ErrorCount { get; private set; }

    internal bool HasTooManyErrors => ErrorCount >= MaxProblems;

    /// <summary>The first problems as text for people, errors before warnings; empty if there are none.</summary>
    public string Report()
    {
        if (Problems.Count == 0) return "";
        var more = Problems.Count <= Printed ? "" : $"and {(Problems.Count < MaxProblems ? "" : "at least ")}{Problems.Count - Printed} more\n";
        return string.Concat(Problems.OrderByDescending(problem => problem.IsError).Take(Printed).Select(problem => $"{problem}\n")) + more;
    }

    internal void Add(bool isError, int start, int end, string message)
    {
        if (isError) ErrorCount++;
        else if (findings.Count >= MaxProblems) return;
        if (message.Length > LongestMessage) message = string.Concat(message.AsSpan(0, LongestMessage), "…");
        findings.Add((isError, start, end, PrintableText.From(message)));
    }

    /// <summary>The content of a mesh file. A file that several models name is read only once.</summary>
    /// <param name="file">The path as the scene writes it; both / and \ separate folders.</param>
    /// <param name="isNew">Whether no model before has named the file.</param>
    internal MeshData Mesh(string file, out bool isNew)
    {
        var path = Path.Combine(folder, file.Replace('\\', '/'));
        var full = Path.GetFullPath(path); // a scene may write the path of one file in several ways
        meshes ??= [];
        isNew = meshes.TryAdd(full, new(() => MeshFile.Read(path, names)));
        return meshes[full].Value;
    }

    /// <summary>Sorts the problems by their places, those at one place as they were found, and lets go of the meshes' data.</summary>
    internal void End()
    {
        Problems = findings.Count == 0 ? [] :
        [
            .. from finding in findings
               orderby finding.Start
               let place = Source.Locate(finding.Start)
               select new Problem(finding.IsError, Source.Name, place.Line, place.Column, finding.Message,
                   Source.Excerpt(finding.Start, finding.End)),
        ];
        if (meshes is not null) MeshFiles = [.. meshes.Keys];
        meshes = null;
    }
}
