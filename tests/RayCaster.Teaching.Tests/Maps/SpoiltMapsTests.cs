using RayCaster.Testing.Fuzzing;

namespace RayCaster.Teaching.Tests.Maps;

/// <summary>Whatever a file of numbers holds, it is read or refused in words.</summary>
public class SpoiltMapsTests
{
    [Fact]
    public void SpoiltMapsDoNoHarm() => Campaign.Run("map", 2000, random => new Mutation(random, Corpus.Maps).Next(), Read);

    /// <summary>The files that once did harm, and some that are made to.</summary>
    [Fact]
    public void AKeptMapDoesNoHarm() => Assert.All(Corpus.KeptFiles(".pfm"), Read);

    private static void Read(SeedFile file)
    {
        try
        {
            Promise.Within(MemoryLimit.OfPicture(file.Bytes.Length, 0, 0), () => PfmFile.Read(new MemoryStream(file.Bytes)));
        }
        catch (PictureFileException e)
        {
            Promise.Wholesome(e.Message);
        }
    }
}
