namespace RayCaster.Testing;

/// <summary>Asserts about whole pictures.</summary>
internal static class PictureAssert
{
    /// <summary>
    /// Fails unless a picture is equal to a reference as <see cref="ReferenceComparison"/> has it. A failure leaves the picture and one of the
    /// differences beside the reference, as NAME.received.png and NAME.diff.png. Nothing is ever accepted here: references are remade
    /// by tests/References/remake.sh.
    /// </summary>
    /// <param name="name">The reference's name, without <c>.png</c>.</param>
    /// <param name="actual">The picture.</param>
    /// <param name="folder">Where the reference is.</param>
    public static void Equal(string name, Picture actual, string? folder = null)
    {
        var reference = folder is null ? Reference.Of(name) : Reference.Read(folder, name);
        folder ??= Reference.Folder;
        var (received, diff) = (Path.Combine(folder, name + ".received.png"), Path.Combine(folder, name + ".diff.png"));
        File.Delete(received);
        File.Delete(diff);

        var comparison = new ReferenceComparison(reference, actual);
        if (comparison.IsEqual) return;

        PictureFile.Write(received, actual);
        var message = $"{comparison.Describe(name)}\n  {received}";
        if (comparison.Draw() is { } differences)
        {
            PictureFile.Write(diff, differences);
            message += $"\n  {diff}";
        }
        Assert.Fail($"{message}\n  Drawn with {actual.Width} × {actual.Height} pixels. "
            + "If the scene was changed on purpose, or a formula was and the new picture "
            + $"is known to be right, remake the reference with POV-Ray: tests/References/remake.sh {name}");
    }
}
