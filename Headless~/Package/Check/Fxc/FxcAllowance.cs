namespace Host.Check
{
    /// <summary>A message of FXC that is not a fault, and why. One that nothing needs any more is a fault itself.</summary>
    sealed class FxcAllowance
    {
        /// <summary>"X3568".</summary>
        public readonly string Number;
        /// <summary>The file that it applies to.</summary>
        public readonly string File;
        public readonly string Reason;

        public FxcAllowance(string number, string file, string reason)
        {
            Number = number;
            File = file;
            Reason = reason;
        }
    }
}
