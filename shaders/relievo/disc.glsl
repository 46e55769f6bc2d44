// Shares of a disc of radius 1, the shape of a light, that straight lines cut off.

// What lies between its middle and a line at a distance from it, negative on the other side.
float reliefDiscUpTo(float line) {
    float x = clamp(line, -1.0, 1.0);
    return (x * sqrt(1.0 - x * x) + asin(x)) / 3.14159265;
}

// What lies between two parallel lines, low ≤ high, and beyond a line at right angles to them.
float reliefSliceBeyond(float low, float high, float line) {
    float height = min(abs(line), 1.0);
    float reach = sqrt(1.0 - height * height);
    float from = clamp(low, -reach, reach);
    float to = clamp(high, -reach, reach);
    // Beyond the line or its mirror image, whichever is farther out.
    float cap = 0.5 * (reliefDiscUpTo(to) - reliefDiscUpTo(from)) - height * (to - from) / 3.14159265;
    cap = max(cap, 0.0);
    return line >= 0.0 ? cap : reliefDiscUpTo(high) - reliefDiscUpTo(low) - cap;
}

// What lies beyond one line.
float reliefDiscBeyond(float line) { return reliefSliceBeyond(-1.0, 1.0, line); }
