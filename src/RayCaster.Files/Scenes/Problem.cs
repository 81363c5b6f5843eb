namespace RayCaster.Files;

/// <summary>A mistake in a scene file, and its place.</summary>
/// <param name="Line">The line, from 1; 0 if it concerns the whole file.</param>
/// <param name="Column">The column, from 1, in UTF-16 units; a byte order mark is not counted, a tab counts as 1.</param>
/// <param name="Message">What is allowed, what was found and what to do: one line that begins with the value, <c>models[3].radius</c>.</param>
/// <param name="Excerpt">The line of the file, and a line with a caret under the value; empty if there is nothing to show.</param>
public sealed record Problem(bool IsError, string File, int Line, int Column, string Message, string Excerpt)
{
    /// <summary>The problem as it is printed. Terminals and editors make the beginning of the first line a link.</summary>
    public override string ToString()
    {
        var place = Line > 0 ? $"{File}({Line},{Column})" : File;
        var text = $"{place}: {(IsError ? "error" : "warning")}: {Message}";
        return Excerpt.Length > 0 ? $"{text}\n{Excerpt}" : text;
    }
}
