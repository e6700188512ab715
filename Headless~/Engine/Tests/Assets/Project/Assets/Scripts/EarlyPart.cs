namespace Fixtures
{
    /// <summary>Its .meta file puts it before all others.</summary>
    public class EarlyPart : Part { }
}
