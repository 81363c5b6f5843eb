using RayCaster.Testing.Fuzzing;

namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>Whatever a file holds, it is read or refused in words: no crash, no hang, no memory beyond what is stated.</summary>
public class FuzzingCampaign
{
    [Fact]
    public void SpoiltScenesDoNoHarm() => Campaign.Run("scene", 3000, random => new Mutation(random, Corpus.Scenes).Next(), Reading.OfScene);

    [Fact]
    public void SpoiltMeshesDoNoHarm() => Campaign.Run("mesh", 5000, random => new Mutation(random, Corpus.Meshes).Next(), Reading.OfMesh);

    [Fact]
    public void SpoiltPicturesDoNoHarm() => Campaign.Run("picture", 5000, random => new Mutation(random, Corpus.Pictures).Next(), Reading.OfPicture);

    [Fact]
    public void AFlippedByteOfATrueColourPngIsNoticed() => new Pictures.BrokenPictureTests().AFlippedByteOfAPngIsNoticed("rgb-8.netpbm-paeth.png");

    /// <summary>A file that is always refused at its first byte tests nothing.</summary>
    [Fact]
    public void ManySpoiltFilesAreStillRead()
    {
        Assert.InRange(Read(Corpus.Scenes, file => SceneReader.Parse(file.Bytes, "x", Corpus.SceneFolder).Scene is not null), 50, 950);
        Assert.InRange(Read(Corpus.Meshes, file => MeshBytes.Read(file.Name, file.Bytes).Indices.Length > 0), 50, 950);
        Assert.InRange(Read(Corpus.Pictures, file => PictureFile.Read(new MemoryStream(file.Bytes)).Width > 0), 50, 950);

        static int Read(SeedFile[] seeds, Func<SeedFile, bool> read) => Enumerable.Range(0, 1000).Count(seed =>
        {
            try
            {
                return read(new Mutation(new Random(seed), seeds).Next());
            }
            catch (ProblemException)
            {
                return false;
            }
        });
    }
}
