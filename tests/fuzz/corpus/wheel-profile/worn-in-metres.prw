! A worn wheel as a profile gauge gives it: S1002 with a hollow of 0.6 mm on the tread, made for
! the tests. The places count from the running circle to the flange; mirror.y turns them round.
header.begin
  version       = 1
  type          = 1
header.end
spline.begin
  approx.smooth = 0
  comment       = 'S1002 with a hollow tread'
  mirror.y      = 1
  inversion     = 1
  units.len.f   = 1.0   ! lengths in this file for a metre
  point.begin
69.500  14.0192
67.000  20.1963
64.500  23.4923
62.000  25.7466
59.500  27.1239
57.000  27.8314
54.500  27.9883
52.000  27.6167
49.500  26.6622
47.000  25.1506
44.500  23.0503
42.000  20.0363
39.500  14.9248
37.000  9.1586
34.500  6.3802
29.500  3.6437
24.500  2.2272
19.500  1.2496
14.500  0.5272
9.500  -0.0117
4.500  -0.3900
-0.500  -0.6161
-5.500  -0.7057
-10.500  -0.6917
-15.500  -0.6253
-20.500  -0.5715
-25.500  -0.5991
-30.500  -0.7629
-35.500  -1.0467
-40.500  -1.3559
-45.500  -1.6773
-50.500  -2.0054
-55.500  -2.3367
  point.end
spline.end
