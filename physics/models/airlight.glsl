// Airlight's own sky: single scattering marched along the ray, higher orders from a small table of their source.
// What it is and leaves out: src/models/airlight.cpp. Theory: docs/theory.md, section 10.1.
//
// A ray is cut where its integrand has an edge: at its perigee, where it enters and leaves the planet's shadow, where a density
// jumps; and after some mean free paths, since what lies beyond is seen less and less. On each piece the nodes of Gauss's rule crowd,
// in altitude, quadratically towards the lower end.

// Densities relative to their references.
struct AirlightDensities {
    Number of[airlight_parts];
};

// Columns of each constituent's air: integrals of its relative density along a ray.
struct AirlightColumns {
    Length of[airlight_parts];
};

// A ray within the air, from its start.
struct AirlightRay {
    Length h;
    Number mu;
    Number mu_s;
    Number nu;
    Length limit;  // where it ends, if it has not met the ground or left the air before
};

// Light that reaches the start of a ray, apart from the sun's disk itself.
struct AirlightLight {
    RadianceSpectrum multiple;                // of two and more scatterings, and from the ground
    IrradianceSpectrum single[airlight_parts];  // one scattering in each constituent; times its phase function it is radiance
    Spectrum transmittance;                   // to the end of the ray
};

// The texel, as a real number, that an altitude falls on.
FN Number airlight_texel(IN(AirlightAxis) axis, Length h, Length top) {
    Number u = altitude_coordinate(h, top);
    int s = 0;
    while (s + 1 < axis.segments && u >= axis.from[s + 1]) s = s + 1;
    Number t = clamp((u - axis.from[s]) * axis.inverse_range[s], Number(0.0), Number(1.0));
    Number v = axis.crowds[s] > 0.5 ? 1.0 - sqrt(1.0 - t) : t;
    return axis.first[s] + v * (axis.last[s] - axis.first[s]);
}

// A row of the table holds four constituents.
FN AirlightDensities airlight_densities(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, Length h) {
    AirlightDensities at;
    Number u = (airlight_texel(air.density_axis, h, air.top) + 0.5) / Number(air.density_axis.texels);
    Spectrum low = look_up(densities, TexCoord2(u, Number(0.25)));
    for (int p = 0; p < 4; ++p) at.of[p] = low[p];
    Spectrum high = air.parts > 4 ? look_up(densities, TexCoord2(u, Number(0.75))) : Spectrum(Number(0.0));
    for (int p = 4; p < 8; ++p) at.of[p] = high[p - 4];
    return at;
}

FN Spectrum airlight_depth(WITH_AIRLIGHT_AIR IN(AirlightColumns) columns) {
    Spectrum depth = air.extinction[0] * columns.of[0];
    for (int p = 1; p < airlight_parts; ++p)
        if (p < air.parts) depth = depth + air.extinction[p] * columns.of[p];
    return depth;
}
FN Spectrum airlight_transmittance(WITH_AIRLIGHT_AIR IN(AirlightColumns) columns) {
    return exp(-airlight_depth(AIRLIGHT_AIR columns));
}

// Transmittance from a point to the top of the air, towards the horizon at the lowest.
FN Spectrum airlight_upward(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_2D(Spectrum)) transmittance, Length h, Number mu) {
    Number u = transmittance_cosine_coordinate(h, max(mu, horizon_cosine(h, air.bottom)), air.bottom, air.top);
    Number v = (airlight_texel(air.transmittance_axis, h, air.top) + 0.5) / Number(air.transmittance_axis.texels);
    Spectrum logarithm = look_up(transmittance, TexCoord2(texture_coordinate(u, air.cosine_texels), v)) * air.depth_range;
    return exp(exp(logarithm) * (-air.least_depth));
}

// Transmittance from a point to the sun, times the part of its disk above the horizon.
FN Spectrum airlight_sunlight(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_2D(Spectrum)) transmittance, Length h, Number mu_s) {
    Number part = sun_above_horizon(h, mu_s, air.bottom, air.sun_radius);
    if (part <= 0.0) return Spectrum(Number(0.0));
    return airlight_upward(AIRLIGHT_AIR transmittance, h, mu_s) * part;
}

// Radiance scattered per scattering coefficient, by light of at least one scattering or reflection, towards where a view of
// zenith cosine mu came from; over the sun's irradiance, per steradian.
FN Spectrum airlight_source(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_3D(Spectrum)) source, Length h, Number mu, Number mu_s, Number nu) {
    Number x = texture_coordinate(sun_coordinate(mu_s), air.sun_texels);
    Number y = texture_coordinate(view_coordinate(mu), air.view_texels);
    Number azimuth = azimuth_coordinate(relative_azimuth_cosine(mu, mu_s, nu)) * Number(air.azimuth_texels - 1);
    int low = int(min(azimuth, Number(air.azimuth_texels - 2)));
    // Azimuths are slabs of the third dimension, one upon the other.
    Number slab = Number(air.source_axis.texels);
    Number z = (airlight_texel(air.source_axis, h, air.top) + 0.5 + slab * Number(low)) / (slab * Number(air.azimuth_texels));
    Number weight = azimuth - Number(low);
    Spectrum value = look_up(source, TexCoord3(x, y, z)) * (1.0 - weight) +
                     look_up(source, TexCoord3(x, y, z + 1.0 / Number(air.azimuth_texels))) * weight;
    return exp(value * air.log_range + Spectrum(air.log_low));
}

// Diffuse irradiance of the ground, over the sun's.
FN Spectrum airlight_diffuse(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_2D(Spectrum)) diffuse, Number mu_s) {
    Number x = texture_coordinate(sun_coordinate(mu_s), air.sun_texels);
    return exp(look_up(diffuse, TexCoord2(x, Number(0.5))) * air.log_range + Spectrum(air.log_low));
}

// Light that the ground sends up where the sun's zenith cosine is mu_s.
FN RadianceSpectrum airlight_ground(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_2D(Spectrum)) transmittance, IN(PACKED_TABLE_2D(Spectrum)) diffuse,
                                    Number mu_s) {
    Spectrum light = airlight_diffuse(AIRLIGHT_AIR diffuse, mu_s);
    // Near the horizon, the part of the disk that is above the plane faces it at about half its height.
    Number facing = mu_s >= air.sun_radius ? mu_s : max(0.5 * (mu_s + air.sun_radius), Number(0.0));
    if (facing > 0.0) light = light + airlight_sunlight(AIRLIGHT_AIR transmittance, 0.0 * m, mu_s) * facing;
    return light * air.ground_albedo * air.solar_irradiance * (1.0 / pi * per_sr);
}

// A piece of a ray on one side of the perigee, from its lower end (u = 0) to its upper one (u = 1), altitudes as the square of u.
struct AirlightPiece {
    bool rises;    // along the ray
    Length h_low;
    Length rise;
    Length x_low;  // distance of the lower end from the perigee
};

// A place on a piece.
struct AirlightPlace {
    Length h;
    Length x;      // signed distance from the perigee
    Length slope;  // of the distance by u
};

// The piece [from, to], in signed distances from the perigee, of a ray that starts at altitude h and distance `start`.
FN AirlightPiece airlight_piece(WITH_AIRLIGHT_AIR Length h, Length start, Length from, Length to) {
    AirlightPiece piece;
    piece.rises = from + to > 0.0 * m;
    Length x_high = piece.rises ? to : -from;
    piece.x_low = max(piece.rises ? from : -to, 0.0 * m);
    Length r = air.bottom + h;
    Area low_gain = (piece.x_low - start) * (piece.x_low + start);
    piece.h_low = max(h + low_gain / (sqrt(max(r * r + low_gain, 0.0 * m * m)) + r), 0.0 * m);
    Area gain = (x_high - piece.x_low) * (x_high + piece.x_low);
    Length r_low = air.bottom + piece.h_low;
    piece.rise = gain / (sqrt(max(r_low * r_low + gain, 0.0 * m * m)) + r_low);
    return piece;
}

// The place a part t, 0 to 1, of the way along a piece, not at its ends.
FN AirlightPlace airlight_place(WITH_AIRLIGHT_AIR IN(AirlightPiece) piece, Number t) {
    Number u = piece.rises ? t : 1.0 - t;
    AirlightPlace place;
    place.h = piece.h_low + piece.rise * (u * u);
    Length x = sqrt(piece.x_low * piece.x_low + piece.rise * (u * u) * (2.0 * air.bottom + place.h + piece.h_low));
    place.slope = 2.0 * piece.rise * u * ((air.bottom + place.h) / x);
    place.x = piece.rises ? x : -x;
    return place;
}

// Adds the air between the parts `from` and `to` of a piece, by Gauss's rule of three nodes.
FN void airlight_add_columns(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, IN(AirlightPiece) piece, Number from, Number to,
                             INOUT(AirlightColumns) columns) {
    Number middle = 0.5 * (from + to);
    Number half_way = 0.5 * (to - from);
    for (int i = -1; i <= 1; ++i) {
        AirlightPlace place = airlight_place(AIRLIGHT_AIR piece, middle + Number(i) * (0.77459666924 * half_way));
        AirlightDensities density = airlight_densities(AIRLIGHT_AIR densities, place.h);
        Length length = place.slope * (half_way * (i == 0 ? Number(8.0 / 9.0) : Number(5.0 / 9.0)));
        for (int p = 0; p < airlight_parts; ++p) columns.of[p] = columns.of[p] + density.of[p] * length;
    }
}

// A place on a ray where its light is gathered.
struct AirlightNode {
    Length h;
    Number mu;                  // of the ray, there
    Length distance;            // from the ray's start
    AirlightDensities density;
    LengthSpectrum seen;        // transmittance from the ray's start, times the length that the node stands for
};

// The node k of a piece. `columns` holds the air up to the node before, or to the piece's start, and receives that up to this one.
FN AirlightNode airlight_node(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, Length start, IN(AirlightPiece) piece, int k,
                              INOUT(AirlightColumns) columns) {
    airlight_add_columns(AIRLIGHT_AIR densities, piece, k > 0 ? air.rule.node[k - 1] : Number(0.0), air.rule.node[k], columns);
    AirlightPlace place = airlight_place(AIRLIGHT_AIR piece, air.rule.node[k]);
    AirlightNode node;
    node.h = place.h;
    node.mu = clamp(place.x / (air.bottom + place.h), Number(-1.0), Number(1.0));
    node.distance = place.x - start;
    node.density = airlight_densities(AIRLIGHT_AIR densities, place.h);
    node.seen = airlight_transmittance(AIRLIGHT_AIR columns) * (air.rule.weight[k] * place.slope);
    return node;
}

// The air from the last node of a piece to its end.
FN void airlight_end_piece(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, IN(AirlightPiece) piece, INOUT(AirlightColumns) columns) {
    airlight_add_columns(AIRLIGHT_AIR densities, piece, air.rule.node[air.rule.count - 1], Number(1.0), columns);
}

// The nearer of two places, where the other one lies beyond x.
FN Length airlight_nearer(Length nearest, Length x, Length other) {
    return other > x && other < nearest ? other : nearest;
}

// Where a ray that starts at altitude h and distance `start` from its perigee is cut next after x by what does not depend on the
// sun: the perigee, a jump of density, some mean free paths; at the latest at `end`. `reach` is how far the piece before was
// allowed to go by mean free paths, if they cut it, else 0; and receives the same of this piece.
FN Length airlight_next_cut(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, Length h, Length start, Length x, Length end,
                            INOUT(Length) reach) {
    Length least = x + 1e-6 * (end - start);
    Length to = airlight_nearer(end, least, 0.0 * m);
    for (int s = 1; s < air.density_axis.segments; ++s) {
        Length jump = altitude_of_coordinate(air.density_axis.from[s], air.top);
        Area squared = start * start + (jump - h) * (2.0 * air.bottom + jump + h);
        Length at_jump = sqrt(max(squared, 0.0 * m * m));
        to = airlight_nearer(airlight_nearer(to, least, -at_jump), least, at_jump);
    }
    Length allowed = 5.0 * reach;
    if (reach <= 0.0 * m) {
        AirlightPlace beside = airlight_place(AIRLIGHT_AIR airlight_piece(AIRLIGHT_AIR h, start, x, to), Number(1e-3));
        AirlightDensities density = airlight_densities(AIRLIGHT_AIR densities, beside.h);
        InverseLength extinction = air.opacity[0] * density.of[0];
        for (int p = 1; p < airlight_parts; ++p)
            if (p < air.parts) extinction = extinction + air.opacity[p] * density.of[p];
        allowed = 2.0 / max(extinction, 1e-30 / (1.0 * m));
    }
    reach = 0.0 * m;
    if (end - x > 4.0 * allowed && to - x > allowed) {
        reach = allowed;
        to = x + allowed;
    }
    return to;
}

// Where a ray next enters or leaves the planet's shadow after x, or else `to`. The shadow is a cylinder whose axis points from the
// sun and whose radius is the ground's. Around it lies light that has grazed dense air: it rises from nothing to nearly all of the
// sun's within two more cylinders, at 6 % and 20 % of the height of the air, which cut the ray too.
FN Length airlight_shadow_cut(WITH_AIRLIGHT_AIR IN(AirlightRay) ray, Length x, Length to) {
    Length r = air.bottom + ray.h;
    Length start = r * ray.mu;
    Number a = 1.0 - ray.nu * ray.nu;
    if (a < 1e-6) return to;
    Length b = r * (ray.mu - ray.mu_s * ray.nu);
    Length least = x + 1e-6 * (to - x);
    for (int i = 0; i < 3; ++i) {
        Length above = (i == 0 ? 0.0 : (i == 1 ? 0.06 : 0.2)) * air.top;
        Area c = (ray.h - above) * (2.0 * air.bottom + ray.h + above) - r * ray.mu_s * (r * ray.mu_s);
        Area discriminant = b * b - a * c;
        if (discriminant > 0.0 * m * m) {
            Length root = sqrt(discriminant);
            Length enters = (-b - root) / a;
            Length leaves = (-b + root) / a;
            if (r * ray.mu_s + ray.nu * enters < 0.0 * m) to = airlight_nearer(to, least, start + enters);
            if (r * ray.mu_s + ray.nu * leaves < 0.0 * m) to = airlight_nearer(to, least, start + leaves);
        }
    }
    return to;
}

// Integrals along a ray, relative to the sun's irradiance.
struct AirlightSums {
    Spectrum multiple;
    LengthSpectrum lit[airlight_parts];  // of each constituent's air, as if of density one
};

FN AirlightSums airlight_nothing() {
    AirlightSums sums;
    sums.multiple = Spectrum(Number(0.0));
    for (int p = 0; p < airlight_parts; ++p) sums.lit[p] = LengthSpectrum(0.0 * m);
    return sums;
}

// Adds the light of a node of a ray.
FN void airlight_gather(WITH_AIRLIGHT_AIR IN(PACKED_TABLE_2D(Spectrum)) transmittance, IN(PACKED_TABLE_3D(Spectrum)) source,
                        IN(AirlightRay) ray, IN(AirlightNode) node, INOUT(AirlightSums) sums) {
    Length r = air.bottom + node.h;
    Number mu_s = clamp(((air.bottom + ray.h) * ray.mu_s + ray.nu * node.distance) / r, Number(-1.0), Number(1.0));
    LengthSpectrum lit = node.seen * airlight_sunlight(AIRLIGHT_AIR transmittance, node.h, mu_s);
    LengthSpectrum seen = node.seen;
#ifdef AIRLIGHT_PASSING  // what stands before the sun, if who includes this text tells of it
    Passing passing = AIRLIGHT_PASSING(node.distance);
    lit = lit * passing.sun;
    seen = seen * passing.sky;
#endif
    ScatteringSpectrum scattering = air.scattering[0] * node.density.of[0];
    sums.lit[0] = sums.lit[0] + lit * node.density.of[0];
    for (int p = 1; p < airlight_parts; ++p)
        if (p < air.parts) {
            scattering = scattering + air.scattering[p] * node.density.of[p];
            sums.lit[p] = sums.lit[p] + lit * node.density.of[p];
        }
    sums.multiple = sums.multiple + airlight_source(AIRLIGHT_AIR source, node.h, node.mu, mu_s, ray.nu) * (scattering * seen);
}

// How far a ray runs in the air.
FN Length airlight_length(WITH_AIRLIGHT_AIR Length h, Number mu, bool grounded) {
    return grounded ? distance_to_ground(h, mu, air.bottom) : distance_to_top(h, mu, air.bottom, air.top);
}

// The light that sums along a whole ray stand for, that of the ground at its end left out.
FN AirlightLight airlight_summed(WITH_AIRLIGHT_AIR IN(AirlightSums) sums, IN(AirlightColumns) columns) {
    AirlightLight light;
    light.transmittance = airlight_transmittance(AIRLIGHT_AIR columns);
    light.multiple = sums.multiple * air.solar_irradiance * per_sr;
    for (int p = 0; p < airlight_parts; ++p) light.single[p] = sums.lit[p] * air.scattering[p] * air.solar_irradiance;
    return light;
}

// The sun's zenith cosine where a ray meets the ground after a length.
FN Number airlight_ground_sun(WITH_AIRLIGHT_AIR IN(AirlightRay) ray, Length length) {
    return clamp(((air.bottom + ray.h) * ray.mu_s + ray.nu * length) / air.bottom, Number(-1.0), Number(1.0));
}

// The light along a ray.
FN AirlightLight airlight_light(WITH_AIRLIGHT_AIR IN(TABLE_2D(Spectrum)) densities, IN(PACKED_TABLE_2D(Spectrum)) transmittance,
                                IN(PACKED_TABLE_3D(Spectrum)) source, IN(PACKED_TABLE_2D(Spectrum)) diffuse, IN(AirlightRay) ray) {
    AirlightColumns columns;
    for (int p = 0; p < airlight_parts; ++p) columns.of[p] = 0.0 * m;
    AirlightSums sums = airlight_nothing();
    bool grounded = meets_ground(ray.h, ray.mu, air.bottom);
    Length length = airlight_length(AIRLIGHT_AIR ray.h, ray.mu, grounded);
    if (ray.limit < length) {
        grounded = false;
        length = ray.limit;
    }
    Length start = (air.bottom + ray.h) * ray.mu;
    Length end = start + length;
    Length x = start;
    Length reach = 0.0 * m;
    while (x < end) {
        Length to = airlight_next_cut(AIRLIGHT_AIR densities, ray.h, start, x, end, reach);
        to = airlight_shadow_cut(AIRLIGHT_AIR ray, x, to);
        AirlightPiece piece = airlight_piece(AIRLIGHT_AIR ray.h, start, x, to);
        for (int k = 0; k < air.rule.count; ++k) {
            AirlightNode node = airlight_node(AIRLIGHT_AIR densities, start, piece, k, columns);
            airlight_gather(AIRLIGHT_AIR transmittance, source, ray, node, sums);
        }
        airlight_end_piece(AIRLIGHT_AIR densities, piece, columns);
        x = to;
    }
    AirlightLight light = airlight_summed(AIRLIGHT_AIR sums, columns);
    if (grounded) {
        Number mu_s = airlight_ground_sun(AIRLIGHT_AIR ray, length);
        RadianceSpectrum ground = airlight_ground(AIRLIGHT_AIR transmittance, diffuse, mu_s);
#ifdef AIRLIGHT_PASSING
        ground = ground * AIRLIGHT_PASSING(length).sun;
#endif
        light.multiple = light.multiple + ground * light.transmittance;
    }
    return light;
}
