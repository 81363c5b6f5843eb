using System.Text;

namespace RayCaster.Files.Tests.Meshes;

public class DecimalNumberTests
{
    [Theory]
    [InlineData("0", 0)]
    [InlineData("-0.0", -0.0)]
    [InlineData("+1.5", 1.5)]
    [InlineData(".5", 0.5)]
    [InlineData("5.", 5)]
    [InlineData("-.5", -0.5)]
    [InlineData("1e-5", 1e-5)]
    [InlineData("1.5E+3", 1500)]
    [InlineData("007", 7)]
    [InlineData("9007199254740993", 9007199254740992)] // 2⁵³ + 1 lies between two doubles; the even one
    [InlineData("9007199254740993.00000000000000001", 9007199254740994)]
    [InlineData("0.000000000000000000001", 1e-21)]
    [InlineData("179769313486231570000e288", double.MaxValue)]
    [InlineData("5e-324", double.Epsilon)]
    [InlineData("1e-400", 0)]
    public void NumberIsTheNearestDouble(string word, double expected)
    {
        Assert.True(TextScanner.TryParse(Encoding.ASCII.GetBytes(word), out var number));
        Assert.Equal(BitConverter.DoubleToInt64Bits(expected), BitConverter.DoubleToInt64Bits(number));
    }

    [Theory]
    [InlineData("")]
    [InlineData("-")]
    [InlineData(".")]
    [InlineData("+-1")]
    [InlineData("1.2.3")]
    [InlineData("1e")]
    [InlineData("e5")]
    [InlineData("1,5")]
    [InlineData("1_000")]
    [InlineData("0x10")]
    [InlineData("1f")]
    [InlineData("1\0")]
    [InlineData("١")]
    [InlineData("−1")]
    [InlineData("nan")]
    [InlineData("NaN")]
    [InlineData("inf")]
    [InlineData("Infinity")]
    [InlineData("-∞")]
    [InlineData("1e400")]
    [InlineData("1e99999999999999999999")]
    public void AnythingElseIsNoNumber(string word) => Assert.False(TextScanner.TryParse(Encoding.UTF8.GetBytes(word), out _));
}
