namespace RayCaster.Cli;

/// <summary>
/// The files of a hand-out that are the same for all courses or are made from the lab's source. They lie beside this program, so it needs no clone
/// of the repository; the project file lists them.
/// </summary>
internal static class HandOutFiles
{
    private const string Source = "src/Lab/";

    public static IEnumerable<(string Path, byte[] Content)> All()
    {
        var folder = Path.Combine(AppContext.BaseDirectory, "handout");
        if (!Directory.Exists(folder))
            throw new ProblemException("the folder handout is not beside this program, which may be a hand-out's own\n" +
                "  Make a hand-out with a clone of the project, or with the installed tool.");
        foreach (var file in Directory.GetFiles(folder, "*", SearchOption.AllDirectories).Order(StringComparer.Ordinal))
            yield return (Path.GetRelativePath(folder, file).Replace('\\', '/'), WithLineFeeds(File.ReadAllBytes(file)));
    }

    /// <summary>A text with LF where a clone has CR LF. What holds a zero byte is no text, as for git.</summary>
    internal static byte[] WithLineFeeds(byte[] content) =>
        content.Contains((byte)0) ? content : Encoding.Latin1.GetBytes(Encoding.Latin1.GetString(content).Replace("\r\n", "\n"));

    /// <summary>All files, with stubs in place of the open bodies of the lab, and with texts that fit. If no step is open, the markers of the
    /// bodies stay.</summary>
    public static List<(string Path, byte[] Content)> With(Func<int, bool> isOpen)
    {
        int[] open = [.. Enumerable.Range(1, LabSteps.Count).Where(isOpen)];
        return [.. All().Select(file => (file.Path, Adapted(file.Path, file.Content)))];

        byte[] Adapted(string path, byte[] content)
        {
            var isCode = path.StartsWith(Source) && path.EndsWith(".cs") && open.Length > 0;
            if (!isCode && !OpenSteps.Concern(path)) return content;
            var text = Encoding.UTF8.GetString(content);
            return Encoding.UTF8.GetBytes(
                isCode ? Bodies.With("src/RayCaster.Lab/" + path[Source.Length..], text, isOpen) : OpenSteps.In(text, open));
        }
    }
}
