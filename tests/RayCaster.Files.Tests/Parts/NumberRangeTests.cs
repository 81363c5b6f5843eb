namespace RayCaster.Files.Tests.Parts;

public class NumberRangeTests
{
    [Fact]
    public void BothEndsBelongToIt()
    {
        var lines = NumberRange.Parse("0..249")!.Value;
        Assert.Equal((0, 249, 250, "0..249"), (lines.First, lines.Last, lines.Count, lines.ToString()));
    }

    [Theory]
    [InlineData("")]
    [InlineData("5")]
    [InlineData("5..4")]
    [InlineData("-1..4")]
    [InlineData("0...4")]
    [InlineData("0..4..5")]
    [InlineData(" 0..4")]
    [InlineData("0..99999999999")]
    public void WhatIsNoRangeIsNone(string text) => Assert.Null(NumberRange.Parse(text));
}
