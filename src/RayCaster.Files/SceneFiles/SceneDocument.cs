namespace RayCaster.Files;

/// <summary>A scene file while it is read: its text, the problems found so far, and the mesh files that it names.</summary>
/// <param name="folder">The folder where paths of mesh files start.</param>
/// <param name="threads">How many threads read and place a large mesh; one per core if left out.</param>
internal sealed class SceneDocument(SourceText text, string folder, int? threads = null)
{
    private const int LongestMessage = 2000; // a mesh file's path in it may have any length
    private readonly List<(bool IsError, int Start, int End, string Message)> findings = [];
    private readonly FileNames names = new();
    private Dictionary<string, Lazy<MeshData>>? meshes; // by full path, each with its data or its exception; most scenes name none

    public int ErrorCount { get; private set; }

    /// <summary>Whether so many errors were found that the rest is not read.</summary>
    public bool IsHopeless => ErrorCount >= SceneReading.MostProblems;

    public SourceText Text => text;

    public int? Threads => threads;

    /// <summary>The full paths of the mesh files that the scene names.</summary>
    public IReadOnlyCollection<string> MeshFiles => meshes is null ? [] : meshes.Keys;

    /// <summary>Notes a problem with the bytes from <paramref name="start"/> to <paramref name="end"/>.</summary>
    public void Add(bool isError, int start, int end, string message)
    {
        if (isError) ErrorCount++;
        else if (findings.Count >= SceneReading.MostProblems) return;
        if (message.Length > LongestMessage) message = string.Concat(message.AsSpan(0, LongestMessage), "…");
        findings.Add((isError, start, end, PrintableText.Of(message)));
    }

    /// <summary>The problems in the order of the text; at one place, in the order in which they were found.</summary>
    public Problem[] Problems()
    {
        if (findings.Count == 0) return [];
        return
        [
            .. from finding in findings
               orderby finding.Start
               let place = text.Locate(finding.Start)
               select new Problem(
                   finding.IsError, text.Name, place.Line, place.Column, finding.Message, text.Excerpt(finding.Start, finding.End)),
        ];
    }

    /// <summary>The content of a mesh file. A file that several models name is read only once.</summary>
    /// <param name="file">The path as the scene writes it; both / and \ separate folders.</param>
    public MeshData Mesh(string file)
    {
        var path = Path.Combine(folder, file.Replace('\\', '/'));
        var place = Path.GetFullPath(path); // a scene may write the path of one file in several ways
        meshes ??= [];
        if (!meshes.TryGetValue(place, out var mesh)) meshes.Add(place, mesh = new(() => MeshFile.Read(path, threads, names)));
        return mesh.Value;
    }
}
