namespace RayCaster.Page;

/// <summary>What is still to be sent to a page.</summary>
[Flags]
internal enum MessageKind
{
    Scene = 1, Hover = 2, Frame = 4, Camera = 8, Explanation = 16, Map = 32, Comparison = 64, Diagnosis = 128, Ledger = 256, All = 511,
}
