using System.Reflection.Metadata;

[assembly: MetadataUpdateHandler(typeof(RayCaster.Live.CodeWatch))]

namespace RayCaster.Live;

/// <summary>What "dotnet watch" does to this program while it runs: the runtime calls it when a changed formula is in place.</summary>
internal static class CodeWatch
{
    /// <summary>Called with true when the code has changed, with false when only the message has.</summary>
    public static event Action<bool>? Changed;

    /// <summary>Whether a formula was changed while the program runs.</summary>
    public static bool HasChanged { get; private set; }

    /// <summary>What a page is told.</summary>
    public static byte[] Message { get; private set; } = Messages.Of(new { Kind = "code", Problem = "" });

    /// <summary>Called by the runtime.</summary>
    public static void UpdateApplication(Type[]? types)
    {
        HasChanged = types is not null;
        Message = Messages.Of(new { Kind = "code", Problem = "" });
        Changed?.Invoke(true);
    }
}
