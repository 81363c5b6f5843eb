namespace RayCaster.Files;

/// <summary>A scene file while it is read: its text, the problems found so far, and the mesh files that it names.</summary>
internal sealed class SceneDocument(SourceText text, string folder)
{
    private const int LongestMessage = 2000; // a mesh file's path in it may have any length
    private readonly List<(bool IsError, int Start, int End, string Message)> findings = [];
    private readonly FileNames names = new();
    private Dictionary<string, Lazy<MeshData>>? meshes; // by full path, each with its data or its exception; most scenes name none

    public int ErrorCount { get; private set; }

    /// <summary>Whether so many errors were found that the rest is not read.</summary>
    public bool HasTooManyErrors => ErrorCount >= SceneReading.MaxProblems;

    public SourceText Text => text;

    public IReadOnlyCollection<string> MeshFiles => meshes is null ? [] : meshes.Keys;

    public void Add(bool isError, int start, int end, string message)
    {
        if (isError) ErrorCount++;
        else if (findings.Count >= SceneReading.MaxProblems) return;
        if (message.Length > LongestMessage) message = string.Concat(message.AsSpan(0, LongestMessage), "…");
        findings.Add((isError, start, end, PrintableText.From(message)));
    }

    /// <summary>The problems in the order of the text; at one place, in the order in which they were found.</summary>
    public Problem[] Problems() => findings.Count == 0 ? [] :
    [
        .. from finding in findings
           orderby finding.Start
           let place = text.Locate(finding.Start)
           select new Problem(finding.IsError, text.Name, place.Line, place.Column, finding.Message, text.Excerpt(finding.Start, finding.End)),
    ];

    /// <summary>The content of a mesh file. A file that several models name is read only once.</summary>
    /// <param name="file">The path as the scene writes it; both / and \ separate folders.</param>
    /// <param name="isNew">Whether no model before has named the file.</param>
    public MeshData Mesh(string file, out bool isNew)
    {
        var path = Path.Combine(folder, file.Replace('\\', '/'));
        var full = Path.GetFullPath(path); // a scene may write the path of one file in several ways
        meshes ??= [];
        isNew = meshes.TryAdd(full, new(() => MeshFile.Read(path, names)));
        return meshes[full].Value;
    }
}
