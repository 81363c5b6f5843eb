namespace RayCaster.Teaching.Tests.Course;

/// <summary>More scenes than the tests take.</summary>
public class StepHintCampaign
{
    [Theory(Explicit = true)]
    [InlineData("plane")]
    [InlineData("room")]
    public void MultipliedByDnIsAVariantOfThePlanes(string file) => new StepHintTests().MultipliedByDnIsAVariantOfThePlanes(file);
}
