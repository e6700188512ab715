using System.Runtime.CompilerServices;

// The headless host's tests call the inspectors.
[assembly: InternalsVisibleTo("Host.Tests")]
