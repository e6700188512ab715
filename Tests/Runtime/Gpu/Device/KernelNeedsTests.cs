using System.Linq;
using NUnit.Framework;

namespace Rill.Tests
{
    /// <summary>The table of what kernels take of a device.</summary>
    public class KernelNeedsTests
    {
        const int SmallThreads = 256, SmallGroupshared = 16384;

        [Test]
        public void Of_each_kernel_the_variant_without_keywords_comes_first()
        {
            foreach (IGrouping<(string, string), KernelNeed> kernel in KernelNeeds.OfKernels.GroupBy(need => (need.File, need.Kernel)))
                Assert.That(kernel.First().Defines.Length, Is.EqualTo(kernel.Min(need => need.Defines.Length)), $"{kernel.Key}");
        }

        [Test]
        public void What_takes_more_than_256_threads_or_16_KB_has_a_small_stand_in_of_the_same_name()
        {
            // But for several materials, which the gate leaves out on a smaller device.
            KernelNeed[] large = KernelNeeds.OfKernels.Where(need => (need.Threads > SmallThreads
                || need.GroupsharedBytes > SmallGroupshared) && !Features.Of(need).Has(Features.Materials)).ToArray();
            Assert.That(large, Is.Not.Empty);
            foreach (KernelNeed need in large)
            {
                KernelNeed small = KernelNeeds.OfKernels.SingleOrDefault(other => other.File == need.File
                    && other.Kernel == need.Kernel + KernelNeed.Small && other.Defines.Replace(" SMALL", "") == need.Defines
                    || other.File == need.File && other.Kernel == need.Kernel + KernelNeed.Small
                    && other.Defines == (need.Defines + " SMALL").Trim());
                Assert.That(small.File, Is.Not.Null, $"{need.File} {need.Kernel} {need.Defines}");
                Assert.That(small.Threads, Is.InRange(1, SmallThreads), small.Kernel);
                Assert.That(small.GroupsharedBytes, Is.AtMost(SmallGroupshared), small.Kernel);
                Assert.That(small.StorageBuffers, Is.AtMost(need.StorageBuffers), small.Kernel);
            }
        }
    }
}
