// Optics of a smooth surface. Includes nothing.
#ifndef RILL_OPTICS_INCLUDED
#define RILL_OPTICS_INCLUDED

// Reflectance of a dielectric, not polarized (Fresnel). cosine: on the side that light comes from; ratio: index there over that beyond.
float Reflectance(float cosine, float ratio)
{
    cosine = saturate(cosine);
    float squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if (squared <= 0.0)
        return 1.0;
    float beyond = sqrt(squared);
    float across = (ratio * cosine - beyond) / max(ratio * cosine + beyond, 1e-6);
    float along = (cosine - ratio * beyond) / max(cosine + ratio * beyond, 1e-6);
    return saturate(0.5 * (across * across + along * along));
}

#endif
