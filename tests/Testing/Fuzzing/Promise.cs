namespace RayCaster.Testing.Fuzzing;

/// <summary>What every reader promises for any file.</summary>
internal static class Promise
{
    /// <summary>A message is short, and has no control characters and no stack trace.</summary>
    public static void Wholesome(string text)
    {
        Assert.InRange(text.Length, 0, 60_000);
        Assert.DoesNotContain("   at RayCaster", text);
        Assert.DoesNotContain("Exception", text);
        foreach (var c in text) Assert.False(char.IsControl(c) && c is not ('\n' or '\t'), $"U+{(int)c:X4} in {text}");
    }

    /// <summary>Reading takes no more memory, all in all.</summary>
    public static void Within(long bytes, Action read)
    {
        var before = GC.GetAllocatedBytesForCurrentThread();
        try
        {
            read();
        }
        finally
        {
            var taken = GC.GetAllocatedBytesForCurrentThread() - before;
            Assert.True(taken <= bytes, $"it took {taken:N0} bytes of memory; docs/limits.md allows {bytes:N0}");
        }
    }
}
