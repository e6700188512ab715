using System;

namespace Rill
{
    /// <summary>A set of features of a fluid.</summary>
    readonly struct FeatureSet : IEquatable<FeatureSet>
    {
        readonly ulong bits;

        FeatureSet(ulong bits) => this.bits = bits;

        /// <summary>Set without any feature.</summary>
        public static FeatureSet None => default;

        public bool IsEmpty => bits == 0;

        public bool Has(Feature feature) => (bits & 1ul << feature.Index) != 0;

        /// <summary>Returns whether the two have a feature in common.</summary>
        public bool HasAny(FeatureSet of) => (bits & of.bits) != 0;

        /// <summary>Returns whether all features of the other are in this one.</summary>
        public bool HasAll(FeatureSet of) => (of.bits & ~bits) == 0;

        public FeatureSet Without(FeatureSet others) => new FeatureSet(bits & ~others.bits);

        /// <summary>Returns this set, with the feature where it is wanted.</summary>
        public FeatureSet With(Feature feature, bool isWanted = true) => isWanted ? this | feature : this;

        public static implicit operator FeatureSet(Feature feature) => new FeatureSet(1ul << feature.Index);

        public static FeatureSet operator |(FeatureSet a, FeatureSet b) => new FeatureSet(a.bits | b.bits);

        public static bool operator ==(FeatureSet a, FeatureSet b) => a.bits == b.bits;

        public static bool operator !=(FeatureSet a, FeatureSet b) => a.bits != b.bits;

        public bool Equals(FeatureSet other) => bits == other.bits;

        public override bool Equals(object other) => other is FeatureSet set && Equals(set);

        public override int GetHashCode() => bits.GetHashCode();

        public override string ToString()
        {
            FeatureSet all = this;
            return string.Join(", ", Array.ConvertAll(Array.FindAll(Features.All, all.Has), feature => feature.Name));
        }
    }
}
