// The sky as a series of functions: cosines of the azimuth from the sun, alone or with Legendre's functions of the zenith angle.
// What it is and leaves out: src/models/dobashi1997.cpp. [Dobashi1997; Lopes2015, eq. 45]
// Whoever calls keeps the factors, and adds them from the highest order down to order 0.

// A sum of cosines by Clenshaw's recurrence in Reinsch's form, which does not cancel towards azimuths of 0 and pi, where a sky has
// its peaks. side: 1 in the sun's half of the sky, else -1; fold: 2 cos(azimuth) - 2 side.
struct CosineSum {
    Number sum;
    Number step;
    Number fold;
    Number side;
};

// Before any term, 0 <= azimuth <= pi.
FN CosineSum cosine_sum(Number azimuth) {
    CosineSum s;
    s.sum = Number(0.0);
    s.step = Number(0.0);
    s.side = azimuth < 0.5 * pi ? Number(1.0) : Number(-1.0);
    Number half_sine = sin(0.5 * (azimuth < 0.5 * pi ? azimuth : pi - azimuth));
    s.fold = -4.0 * s.side * half_sine * half_sine;
    return s;
}

// With the factor of the next lower order, down to order 1.
FN CosineSum cosine_term(IN(CosineSum) s, Number factor) {
    CosineSum next = s;
    next.step = factor + s.fold * s.sum + s.side * s.step;
    next.sum = next.step + s.side * s.sum;
    return next;
}

// The sum of all, with the factor of order 0.
FN Number cosine_series(IN(CosineSum) s, Number factor) {
    return factor + 0.5 * s.fold * s.sum + s.side * s.step;
}

// Legendre's function of a degree and an order, and of the degree below, scaled so that the square's integral over -1 <= mu <= 1 is 1.
struct Legendre {
    Number here;
    Number before;
};

// Of a degree equal to the order.
FN Legendre legendre_first(int order, Number mu) {
    Number square = 0.5 * (2.0 * Number(order) + 1.0);
    for (int k = 1; k <= order; k++) square *= (1.0 - 0.5 / Number(k)) * (1.0 - mu) * (1.0 + mu);
    Legendre p;
    p.here = sqrt(square);
    p.before = Number(0.0);
    return p;
}

// Of the next degree, which is `degree`.
FN Legendre legendre_next(IN(Legendre) p, int degree, int order, Number mu) {
    Number l = Number(degree);
    Number m2 = Number(order) * Number(order);
    Number k = l - 1.0;
    Number last = sqrt(max(k * k - m2, Number(0.0)) / abs(4.0 * k * k - 1.0));
    Legendre next;
    next.here = sqrt((4.0 * l * l - 1.0) / (l * l - m2)) * (mu * p.here - last * p.before);
    next.before = p.here;
    return next;
}

// Between two suns, bands or azimuths that have a series or a value each: weight of the second. [Lopes2015, eq. 50]
FN Number dobashi1997_between(Number first, Number second, Number weight) {
    return first + weight * (second - first);
}
