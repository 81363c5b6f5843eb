namespace RayCaster.Files.Tests;

/// <summary>Tests that count the allocations of all threads, or take about a gigabyte: no other test runs beside them.</summary>
[CollectionDefinition(Name, DisableParallelization = true)]
public class Alone
{
    public const string Name = "alone";
}
