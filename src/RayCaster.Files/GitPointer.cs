namespace RayCaster.Files;

/// <summary>The short text that Git LFS leaves in place of a large file until that is fetched.</summary>
internal static class GitPointer
{
    public const string Advice = "this is only a Git LFS pointer to the file; fetch the file itself: git lfs pull";

    public static ReadOnlySpan<byte> Start => "version https://git-lfs"u8;

    public static bool Is(ReadOnlySpan<byte> file) => file.StartsWith(Start);
}
