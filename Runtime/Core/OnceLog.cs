namespace Rill
{
    /// <summary>Remembers which problems of an object were logged, so that each is logged once. Problems have numbers from 0 to 31.</summary>
    struct OnceLog
    {
        uint logged;    // bit p: problem p was logged

        /// <summary>Returns true the first time, and then not before the problem is reset.</summary>
        public bool ShouldLog(int problem) => ShouldLog(problem, true);

        /// <summary>Returns true once for as long as a problem lasts.</summary>
        public bool ShouldLog(int problem, bool lasts)
        {
            uint bit = 1u << problem;
            bool isNew = lasts && (logged & bit) == 0;
            logged = lasts ? logged | bit : logged & ~bit;
            return isNew;
        }

        /// <summary>Lets a problem be logged again.</summary>
        public void Reset(int problem) => logged &= ~(1u << problem);

        /// <summary>Lets all problems be logged again.</summary>
        public void Reset() => logged = 0;
    }
}
