namespace RayCaster.Teaching;

/// <summary>Where a student's program runs, and which files it may see where others can be hidden from it.</summary>
/// <param name="Folder">The current folder.</param>
/// <param name="Temporary">Its home, and the folder for temporary files.</param>
/// <param name="Root">An empty folder, at which its root folder is mounted.</param>
/// <param name="Writable">Files and folders that it may change.</param>
/// <param name="Readable">Files and folders that it may only read, besides the system's.</param>
internal sealed record ProgramPlace(string Folder, string Temporary, string Root, IReadOnlyList<string> Writable, IReadOnlyList<string> Readable);
