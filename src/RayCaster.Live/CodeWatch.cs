using System.Reflection.Metadata;

[assembly: MetadataUpdateHandler(typeof(RayCaster.Live.CodeWatch))]

namespace RayCaster.Live;

/// <summary>What "dotnet watch" does to this program while it runs: the runtime calls it when a changed formula is in place.</summary>
internal static class CodeWatch
{
    /// <summary>Called when a changed formula is in place.</summary>
    public static event Action? Changed;

    /// <summary>Whether a formula was changed while the program runs.</summary>
    public static bool HasChanged { get; private set; }

    /// <summary>Called by the runtime.</summary>
    public static void UpdateApplication(Type[]? types)
    {
        _ = types;
        HasChanged = true;
        Changed?.Invoke();
    }
}
