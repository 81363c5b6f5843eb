namespace RayCaster.Cli;

/// <summary>Where a picture goes: a file that is there whole or not at all, or standard output.</summary>
internal static class PictureOutput
{
    /// <summary>Opens it, has it written and closes it.</summary>
    /// <param name="output">The file, or "-".</param>
    /// <param name="write">Writes the picture.</param>
    /// <exception cref="ProblemException">Nobody takes the picture.</exception>
    /// <exception cref="PictureFileException">The file does not do.</exception>
    public static void Write(string output, Action<Stream> write)
    {
        if (output != SceneInput.Standard)
        {
            using var file = new ReplacedFile(output);
            write(file);
            file.Commit();
            return;
        }
        try
        {
            using var stream = StandardFile.OpenOutput();
            try
            {
                write(stream);
            }
            finally
            {
                StandardFile.Leave(stream);
            }
        }
        catch (IOException problem)
        {
            throw new ProblemException($"raycaster: cannot write to standard output: {problem.Message}");
        }
    }
}
