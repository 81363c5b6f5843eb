namespace RayCaster.Files.Tests;

public class AccentsTests
{
    [Theory]
    [InlineData("Zo\u00EB \u00C0\u017E.obj", "Zoe\u0308 A\u0300z\u030C.obj")]
    [InlineData("Nguy\u1EC5n Vi\u1EC7t", "Nguye\u0302\u0303n Vie\u0323\u0302t")] // two marks
    [InlineData("Nguy\u1EC5n", "Nguy\u00EA\u0303n")] // taken apart in half
    [InlineData("L\u01DA", "Lu\u0308\u030C")]
    [InlineData("\u0421\u0435\u0440\u0433\u0435\u0439", "\u0421\u0435\u0440\u0433\u0435\u0438\u0306")] // Sergei
    [InlineData("\u30AC\u30E9\u30B9", "\u30AB\u3099\u30E9\u30B9")] // kana with a voiced sound mark
    [InlineData("\uAE40\uCCA0", "\u1100\u1175\u11B7\u110E\u1165\u11AF")] // Korean syllables
    [InlineData("\u212Bse", "\u00C5se")]
    [InlineData("\uD83D\uDE00 a", "\uD83D\uDE00 a")]
    public void ANameIsTheSameHoweverItsAccentsAreEncoded(string one, string other) =>
        Assert.True(Accents.AreEquivalent(one, other) && Accents.AreEquivalent(other, one));

    [Theory]
    [InlineData("Zo\u00EB", "Zoe")]
    [InlineData("Zo\u00E9", "Zo\u00EB")]
    [InlineData("Zo\u00E9", "Zoe\u0308")]
    [InlineData("Zo\u00E9", "Zoe\u0301\u0323")]
    [InlineData("\u00D3scar", "O'scar")]
    [InlineData("\uAE40", "\u1107\u1161\u11A8")]
    [InlineData("Jos\u00E9", "Jose\u0301s")]
    public void OtherLettersOrMarksAreAnotherName(string one, string other) =>
        Assert.False(Accents.AreEquivalent(one, other) || Accents.AreEquivalent(other, one));
}
