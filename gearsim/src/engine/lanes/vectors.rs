//! The vector instructions that the kernel is compiled for: AVX2 on x86, and those of the target elsewhere. There is only one set, because
//! the whole kernel is compiled again for each set.

use pulp::NullaryFnOnce;
#[cfg(target_arch = "x86_64")]
use pulp::x86::V3;

/// A processor that has these instructions.
#[derive(Debug, Clone, Copy)]
pub struct Vectors {
    #[cfg(target_arch = "x86_64")]
    avx2: V3,
}

/// All values are equal, because a processor has one set.
impl PartialEq for Vectors {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Vectors {
    /// `None` on x86 without AVX2: all events are then taken by the general loop.
    pub fn of_processor() -> Option<Self> {
        #[cfg(target_arch = "x86_64")]
        return V3::try_new().map(|avx2| Vectors { avx2 });
        #[cfg(not(target_arch = "x86_64"))]
        return Some(Vectors {});
    }

    /// Runs a job compiled for these instructions: its `call` and all that is inlined into it.
    #[inline(always)]
    pub fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
        #[cfg(target_arch = "x86_64")]
        return self.avx2.vectorize(job);
        #[cfg(not(target_arch = "x86_64"))]
        return job.call();
    }
}
